#include "filters/core/base/phrase.h"

#include <utility>

namespace boxprobe {

Phrase Phrase::tr(const char* pattern) {
  Phrase phrase;
  phrase.text_ = pattern;
  phrase.translated_ = true;
  return phrase;
}

Phrase Phrase::plain(std::string text) {
  Phrase phrase;
  phrase.text_ = std::move(text);
  return phrase;
}

Phrase Phrase::arg(Phrase part) const {
  Phrase filled = *this;
  filled.parts_.push_back(std::move(part));
  return filled;
}

std::string Phrase::english() const {
  return in([](const char* pattern) { return std::string(pattern); });
}

// In one pass: a value may contain a percent sign and a digit itself.
std::string Phrase::in(const std::function<std::string(const char*)>& translate) const {
  if (!translated_) return text_;
  const std::string pattern = translate(text_.c_str());
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const std::size_t place =
        pattern[i] == '%' && i + 1 < pattern.size() ? static_cast<std::size_t>(pattern[i + 1] - '1') : parts_.size();
    if (place < parts_.size()) {
      text += parts_[place].in(translate);
      ++i;
    } else {
      text += pattern[i];
    }
  }
  return text;
}

std::vector<std::string> english(const std::vector<Phrase>& phrases) {
  std::vector<std::string> texts;
  for (const Phrase& phrase : phrases) texts.push_back(phrase.english());
  return texts;
}

Phrase commaList(const std::vector<Phrase>& parts) {
  Phrase list;
  for (const Phrase& part : parts) list = list.empty() ? part : Phrase::tr("%1, %2").arg(list).arg(part);
  return list;
}

}  // namespace boxprobe
