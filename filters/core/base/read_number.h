// Text as a number, independent of the locale, with the errors of std::from_chars.
#pragma once

#include <charconv>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>

namespace boxprobe {

/// What std::from_chars reads, by a stream. Of "nan(...)" the first three letters.
inline std::from_chars_result readNumberByStream(const char* first, const char* last, double& value) {
  const char* const begin = first < last && *first == '-' ? first + 1 : first;
  const auto word = [begin, last](std::string_view wanted) {
    if (static_cast<std::size_t>(last - begin) < wanted.size()) return false;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if ((begin[i] | 0x20) != wanted[i]) return false;
    }
    return true;
  };
  using Limits = std::numeric_limits<double>;
  for (const std::string_view wanted : {"infinity", "inf", "nan"}) {
    if (!word(wanted)) continue;
    const double read = wanted == "nan" ? Limits::quiet_NaN() : Limits::infinity();
    value = begin > first ? -read : read;
    return {begin + wanted.size(), std::errc()};
  }
  const auto digits = [last](const char* at) {
    while (at < last && *at >= '0' && *at <= '9') ++at;
    return at;
  };
  const char* end = digits(begin);
  auto count = end - begin;
  if (end < last && *end == '.') {
    const char* const fraction = digits(end + 1);
    count += fraction - end - 1;
    if (count > 0) end = fraction;
  }
  if (count == 0) return {first, std::errc::invalid_argument};
  if (end < last && (*end == 'e' || *end == 'E')) {
    const char* const exponent = end + 1 < last && (end[1] == '-' || end[1] == '+') ? end + 2 : end + 1;
    if (digits(exponent) > exponent) end = digits(exponent);
  }
  std::istringstream stream(std::string(first, end));
  stream.imbue(std::locale::classic());
  double read = 0.0;
  if (!(stream >> read)) return {end, std::errc::result_out_of_range};
  value = read;
  return {end, std::errc()};
}

/// libc++ has std::from_chars for whole numbers alone.
inline std::from_chars_result readNumber(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  return readNumberByStream(first, last, value);
#endif
}

}  // namespace boxprobe
