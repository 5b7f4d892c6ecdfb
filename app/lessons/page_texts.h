// The page's own words, those of its scripts and of page.json, in another language: FOLDER/page/LANGUAGE.json. Texts of
// lessons stand elsewhere (filters/io/scene/lesson_texts.h).
#pragma once

#include <map>
#include <string>
#include <vector>

namespace boxprobe {

class PageTexts {
 public:
  /// English: every text is its own.
  PageTexts() = default;
  /// English for a language without that file. Throws InputError for one that cannot be read.
  PageTexts(const std::string& folder, const std::string& language);

  const std::string& language() const { return language_; }
  /// That nobody has read the translation over, in its language; empty: somebody has.
  const std::string& unreviewed() const { return unreviewed_; }
  /// In the page's language, or as it is. "{0}", "{1}", .. in it are the values.
  std::string operator()(const std::string& english, const std::vector<std::string>& values = {}) const;
  const std::map<std::string, std::string>& all() const { return texts_; }

 private:
  std::string language_ = "en", unreviewed_;
  std::map<std::string, std::string> texts_;
};

}  // namespace boxprobe
