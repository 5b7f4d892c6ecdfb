#include "filters/core/base/printable_text.h"

#include <cstdint>

namespace boxprobe {

namespace {

/// The number of bytes of the well-formed UTF-8 sequence at `at`, and its value in `code`; 0 if none starts here
/// (Unicode 15, table 3-7).
std::size_t sequenceAt(const std::string& text, std::size_t at, std::uint32_t& code) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(at);
  code = first;
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  code = first & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0u) != 0x80u) return 0;
    code = (code << 6) | (byte(at + i) & 0x3fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return overlong || surrogate || code > 0x10ffff ? 0 : length;
}

bool isControl(std::uint32_t code) {
  const auto between = [code](std::uint32_t low, std::uint32_t high) { return code >= low && code <= high; };
  return code < 0x20 || between(0x7f, 0x9f) || between(0x2028, 0x202e) || between(0x2066, 0x2069);
}

}  // namespace

std::string printable(const std::string& text, bool keepLines) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t code = 0;
    const std::size_t length = sequenceAt(text, at, code);
    if (length == 0) {
      result += "\xef\xbf\xbd";
    } else if (isControl(code) && !(keepLines && code == '\n')) {
      result += ' ';
    } else {
      result.append(text, at, length);
    }
    at += length == 0 ? 1 : length;
  }
  return result;
}

}  // namespace boxprobe
