// Numbers as text for people, independent of the locale: a fixed number of decimals, or an exponent where those would
// show only zeros or too many digits.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace boxprobe {

inline std::string fixedText(double value, int decimals = 4) {
  if (std::isnan(value)) return "undefined";
  if (std::isinf(value)) return value > 0.0 ? "infinite" : "-infinite";
  constexpr double kLongest = 1e7;  // digits before the point that still read at a glance
  const double smallest = 0.5 * std::pow(10.0, -decimals);
  const double size = std::abs(value);
  const bool exponent = size >= kLongest || (size > 0.0 && size < smallest);
  char buffer[64];
  const auto format = exponent ? std::chars_format::scientific : std::chars_format::fixed;
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value, format, exponent ? 2 : decimals).ptr;
  const std::string text(buffer, end);
  return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

}  // namespace boxprobe
