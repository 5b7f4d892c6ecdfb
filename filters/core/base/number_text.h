// Numbers as the shortest text that parses back to the same value, independent of the locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <string>

namespace boxprobe {

/// Shortest decimal text of a float or double that parses back to the same value: 0.1f is "0.1".
template <typename Number>
std::string numberText(Number value) {
  char buffer[64];  // longest shortest-form double is 24 characters
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

/// With that many decimals, however small or large it is.
inline std::string decimalText(double value, int decimals) {
  char buffer[400];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr};
}

/// "2.4 GB": three digits, of 10^9 bytes.
inline std::string gigabytesText(std::uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g GB", static_cast<double>(bytes) / 1.0e9);
  return text;
}

}  // namespace boxprobe
