// See page_texts.h.
#include "app/lessons/page_texts.h"

#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"
#include "filters/io/json/json_text.h"

namespace boxprobe {

PageTexts::PageTexts(const std::string& folder, const std::string& language) {
  const auto path = std::filesystem::path(folder) / "page" / (language + ".json");
  if (language == "en" || !std::filesystem::exists(path)) return;
  const auto refuse = [&](const std::string& place) {
    throw InputError(oneLine(path.string() + ": " + place +
                             "; expected {\"format\": \"boxprobe-lesson-page-text\", \"version\": 1, \"language\": \"" +
                             language + "\", \"unreviewed\": S, \"texts\": {ENGLISH: TEXT, ..}}"));
  };
  const Json json = parseJsonText(readWholeFile(path.string()), path.string()).root;
  if (!json.is_object()) refuse("is not a JSON object");
  const auto value = [&](const char* key) { return json.value(key, Json()); };
  if (value("format") != "boxprobe-lesson-page-text") refuse("format");
  if (value("version") != 1) refuse("version");
  if (value("language") != language) refuse("language");
  if (json.contains("unreviewed") && !value("unreviewed").is_string()) refuse("unreviewed");
  unreviewed_ = json.value("unreviewed", "");
  if (!value("texts").is_object()) refuse("texts");
  for (const auto& [english, text] : json.at("texts").items()) {
    if (!text.is_string()) refuse("texts." + english);
    texts_[english] = text;
  }
  language_ = language;
}

std::string PageTexts::operator()(const std::string& english, const std::vector<std::string>& values) const {
  const auto found = texts_.find(english);
  std::string text = found != texts_.end() ? found->second : english;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string place = "{" + std::to_string(i) + "}";
    const std::size_t at = text.find(place);
    if (at != std::string::npos) text.replace(at, place.size(), values[i]);
  }
  return text;
}

}  // namespace boxprobe
