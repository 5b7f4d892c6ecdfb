// Numbers of text formats as programs write them whose language has a decimal comma.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "filters/core/base/read_number.h"

namespace boxprobe {

/// For the warning of a reader that takes such numbers.
constexpr const char* kDecimalCommas = "has decimal commas, which are read as points";

/// The value of "-0,45": digits around one comma, no point. Formats whose numbers stand between spaces have no other
/// use for a comma, so the meaning is certain. Empty for anything else.
inline std::optional<double> decimalCommaNumber(std::string_view word) {
  const std::size_t comma = word.find(',');
  if (comma == 0 || comma == std::string_view::npos || word.find('.') != std::string_view::npos) return {};
  std::string text(word);
  text[comma] = '.';
  const auto digit = [&text](std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
  if (!digit(comma - 1) || !digit(comma + 1)) return {};
  const char* const from = text.data() + (text.front() == '+' ? 1 : 0);
  double value = 0.0;
  const auto result = readNumber(from, text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
  return value;
}

}  // namespace boxprobe
