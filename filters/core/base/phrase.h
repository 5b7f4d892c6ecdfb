// A text for people as a pattern and the values in it, so that a window can say it in another language. The command
// line and JSON take it in English.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace boxprobe {

class Phrase {
 public:
  /// Nothing.
  Phrase() = default;
  /// A text with places %1 to %9. Named like Qt's function, so that lupdate finds the text here: a literal.
  static Phrase tr(const char* pattern);
  /// The same in every language: a name, a number, a formula.
  static Phrase plain(std::string text);

  /// Fills the next place, the first being %1.
  Phrase arg(Phrase part) const;
  Phrase arg(std::string text) const { return arg(plain(std::move(text))); }

  bool empty() const { return text_.empty(); }
  std::string english() const;
  /// In another language. `translate` is given the patterns, and returns them with the same places in any order.
  std::string in(const std::function<std::string(const char*)>& translate) const;

 private:
  std::string text_;
  bool translated_ = false;
  std::vector<Phrase> parts_;
};

/// Each in English.
std::vector<std::string> english(const std::vector<Phrase>& phrases);

/// "a, b, c".
Phrase commaList(const std::vector<Phrase>& parts);

}  // namespace boxprobe
