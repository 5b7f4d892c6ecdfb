// See lesson_language.h.
#include "app/lessons/lesson_language.h"

#include <algorithm>
#include <cstdlib>

#include "filters/io/scene/lesson_file.h"

namespace boxprobe {

std::string languageOfLocale(const std::string& locale, const std::vector<std::string>& there) {
  std::string language = locale.substr(0, locale.find_first_of(".@"));
  std::replace(language.begin(), language.end(), '_', '-');
  for (const std::string& wanted : {language, language.substr(0, language.find('-'))}) {
    if (std::find(there.begin(), there.end(), wanted) != there.end()) return wanted;
  }
  return "en";
}

std::string messageLocale() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* locale = std::getenv(name);
    if (locale != nullptr && *locale != '\0') return locale;
  }
  return {};
}

std::string lessonLanguage(const std::string& asked, const std::string& folder) {
  return asked.empty() ? languageOfLocale(messageLocale(), lessonLanguages(folder)) : asked;
}

}  // namespace boxprobe
