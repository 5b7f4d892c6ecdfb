// Lines, words and numbers of OBJ and MTL files, as programs and people write them.
#pragma once

#include <string>
#include <string_view>

namespace boxprobe {

/// Logical lines: they end with line feeds, carriage returns or both, and continue behind a backslash at their end. A
/// byte order mark at the start is skipped.
class ObjLines {
 public:
  /// `bytes` must outlive the object.
  explicit ObjLines(const std::string& bytes);
  /// The next line, trimmed; false at the end. The view is valid until the next call.
  bool next(std::string_view& line);
  /// Number of the line read last, from 1; of several joined ones, the first.
  std::size_t number() const { return number_; }
  /// Fraction read so far.
  double done() const { return static_cast<double>(at_) / static_cast<double>(bytes_.size() + 1); }

 private:
  std::string_view nextRaw();

  std::string_view bytes_;
  std::string joined_;
  std::size_t at_ = 0, raw_ = 0, number_ = 0;
};

/// The bytes of a text file as UTF-8: one that starts with the byte order mark of UTF-16 is converted.
std::string utf8Text(std::string bytes);

/// Without spaces, tabs and carriage returns at both ends.
std::string_view trimmedText(std::string_view text);
/// Removes the first word, between spaces or tabs, from `rest` and returns it; empty at the end.
std::string_view nextObjWord(std::string_view& rest);
/// As nextObjWord, but a comment ends the line: for lines without names, which may contain '#'.
std::string_view nextObjValue(std::string_view& rest);
/// The text without a pair of quotes around it.
std::string unquoted(std::string_view text);
std::string lowerText(std::string_view text);

/// Independent of the locale. False unless the whole word is a number; "nan", "1.#IND" (as some programs write it) and
/// numbers beyond double precision are numbers, and not finite.
bool readObjNumber(std::string_view word, double& value);

}  // namespace boxprobe
