// Lines of words and numbers, against those that a file of the sources keeps. Numbers may be off by one and a half of
// their last digit, whole numbers by nothing: what compilers and C libraries round differently is no fault.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace boxprobe::test {

/// `value` with so many significant digits; what is nothing beside 1 is 0.
inline std::string keptNumber(double value, int digits = 5) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.*g", digits, std::abs(value) < 1e-6 ? 0.0 : value);
  const std::string number = text;
  // A whole number would have to agree exactly.
  return number.find_first_not_of("-0123456789") == std::string::npos ? number + ".0" : number;
}

template <typename Vector>
std::string keptVector(const Vector& v, int digits = 5) {
  return keptNumber(v[0], digits) + " " + keptNumber(v[1], digits) + " " + keptNumber(v[2], digits);
}

/// Nothing beside the numbers that are kept, most of which are near 1: rounding of single precision.
constexpr double kKeptNoise = 1e-5;

/// A number at the start of `text`: its characters, its value and how far off another may be. Nothing: no characters.
struct NumberAhead {
  std::size_t length = 0;
  double value = 0.0, tolerance = 0.0;
};

inline NumberAhead numberAhead(const std::string& text, std::size_t at) {
  std::size_t end = at;
  const auto digits = [&] {
    const std::size_t first = end;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end - first;
  };
  if (end < text.size() && text[end] == '-') ++end;
  if (digits() == 0) return {};
  NumberAhead number;
  int decimals = 0;
  if (end + 1 < text.size() && text[end] == '.' && text[end + 1] >= '0' && text[end + 1] <= '9') {
    ++end;
    decimals = static_cast<int>(digits());
  }
  int exponent = 0;
  if (end + 2 < text.size() && text[end] == 'e' && (text[end + 1] == '-' || text[end + 1] == '+')) {
    exponent = std::atoi(text.c_str() + end + 1);
    end += 2;
    digits();
  }
  number.length = end - at;
  number.value = std::strtod(text.substr(at, number.length).c_str(), nullptr);
  const double digit = std::pow(10.0, exponent - decimals);
  number.tolerance = decimals > 0 || exponent != 0 ? std::max(1.5 * digit, kKeptNoise) : 0.0;
  return number;
}

/// The same words, and numbers that are near? Spaces, which align columns, count as one.
inline bool sameKeptLine(const std::string& a, const std::string& b) {
  const auto skip = [](const std::string& text, std::size_t& at) {
    while (at < text.size() && text[at] == ' ') ++at;
  };
  std::size_t i = 0, j = 0;
  while (true) {
    skip(a, i);
    skip(b, j);
    if (i >= a.size() || j >= b.size()) return i >= a.size() && j >= b.size();
    const NumberAhead x = numberAhead(a, i), y = numberAhead(b, j);
    if (x.length > 0 && y.length > 0) {
      if (std::abs(x.value - y.value) > std::max(x.tolerance, y.tolerance)) return false;
      i += x.length;
      j += y.length;
    } else if (a[i++] != b[j++]) {
      return false;
    }
  }
}

/// `file`: its path below the sources. If the environment has BOXPROBE_WRITE_VALUES, it is written anew instead.
inline void expectKeptValues(const std::string& file, const std::vector<std::string>& lines) {
  const std::string path = std::string(BOXPROBE_SOURCE_DIR) + "/" + file;
  if (std::getenv("BOXPROBE_WRITE_VALUES") != nullptr) {
    std::ofstream out(path);
    for (const std::string& line : lines) out << line << '\n';
    ASSERT_TRUE(out.flush()) << path;
    return;
  }
  std::ifstream in(path);
  ASSERT_TRUE(in) << path;
  std::vector<std::string> kept;
  for (std::string line; std::getline(in, line);) kept.push_back(line);
  EXPECT_EQ(lines.size(), kept.size());
  std::string title;  // of what the line belongs to
  int wrong = 0;
  for (std::size_t i = 0; i < std::min(lines.size(), kept.size()) && wrong < 20; ++i) {
    if (kept[i].rfind("== ", 0) == 0) title = kept[i];
    const bool same = sameKeptLine(lines[i], kept[i]);
    EXPECT_TRUE(same) << file << ":" << i + 1 << " " << title << "\n  is   " << lines[i] << "\n  kept " << kept[i];
    wrong += same ? 0 : 1;
  }
}

}  // namespace boxprobe::test
