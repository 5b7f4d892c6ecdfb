// Which language lessons are shown in: the one asked for, else that of the user's locale. Called by `boxprobe lessons`
// and the window; knows no lesson.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// Of the languages `there`, the one of a locale such as "pt_BR.UTF-8": pt-BR, else pt, else English.
std::string languageOfLocale(const std::string& locale, const std::vector<std::string>& there);

/// The locale that messages are in, by the environment (POSIX: LC_ALL, LC_MESSAGES, LANG); empty: none.
std::string messageLocale();

/// `asked`, or where that is empty the locale's among those that the lessons of `folder` have texts in.
std::string lessonLanguage(const std::string& asked, const std::string& folder);

}  // namespace boxprobe
