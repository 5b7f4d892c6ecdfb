// Text as a number, independent of the locale, with the errors of std::from_chars.
#pragma once

#include <charconv>

#ifndef __cpp_lib_to_chars
#include <cstring>
#include <locale>
#include <sstream>
#include <string>
#endif

namespace boxprobe {

#ifdef __cpp_lib_to_chars
inline std::from_chars_result readNumber(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}
#else
/// libc++ has std::from_chars for whole numbers alone. The longest beginning that is a number is read by a stream.
inline std::from_chars_result readNumber(const char* first, const char* last, double& value) {
  const auto digits = [last](const char* at) {
    while (at < last && *at >= '0' && *at <= '9') ++at;
    return at;
  };
  const char* const begin = first < last && *first == '-' ? first + 1 : first;
  const char* end = digits(begin);
  long count = end - begin;
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
#endif

}  // namespace boxprobe
