// Lines with numbers that a test finds, against those that a file keeps: words are to be the same, numbers nearly.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace boxprobe::test {

/// Whole numbers with all their digits, others with five; what is as good as 0 is 0, whatever its sign.
inline std::string keptNumber(double value) {
  char text[40];
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  std::snprintf(text, sizeof text, whole ? "%.0f" : "%.5g", std::abs(value) < 1e-9 ? 0.0 : value);
  return text;
}

template <typename... Values>
std::string keptNumbers(Values... values) {
  std::string text;
  ((text += " " + keptNumber(static_cast<double>(values))), ...);
  return text;
}

inline bool isWhole(const std::string& text) {
  return text.find_first_not_of("-0123456789") == std::string::npos;
}

/// The same words and whole numbers in the same places; other numbers may be off by `tolerance` of themselves, and by
/// as much of 1.
inline bool nearlySameLine(const std::string& found, const std::string& kept, double tolerance) {
  std::istringstream a(found), b(kept);
  std::string x, y;
  while (a >> x) {
    if (!(b >> y)) return false;
    if (x == y) continue;
    if (isWhole(x) && isWhole(y)) return false;
    char *endX = nullptr, *endY = nullptr;
    const double u = std::strtod(x.c_str(), &endX), v = std::strtod(y.c_str(), &endY);
    if (*endX != '\0' || *endY != '\0' || !(std::abs(u - v) <= tolerance * std::max(1.0, std::abs(v)))) return false;
  }
  return !(b >> y);
}

/// `name`: of the file below tests. If the environment has `variable`, the file is written anew instead.
inline void expectKeptNumbers(const std::string& name, const char* variable, const std::vector<std::string>& lines,
                              double tolerance = 2e-4) {
  const std::string path = std::string(BOXPROBE_SOURCE_DIR) + "/tests/" + name;
  if (std::getenv(variable) != nullptr) {
    std::ofstream file(path);
    for (const std::string& line : lines) file << line << '\n';
    ASSERT_TRUE(file.flush()) << path;
    return;
  }
  std::ifstream file(path);
  ASSERT_TRUE(file) << path;
  std::vector<std::string> kept;
  for (std::string line; std::getline(file, line);) kept.push_back(line);
  EXPECT_EQ(lines.size(), kept.size());
  for (std::size_t i = 0; i < std::min(lines.size(), kept.size()); ++i) {
    EXPECT_TRUE(nearlySameLine(lines[i], kept[i], tolerance))
        << name << ":" << i + 1 << "\n  found " << lines[i] << "\n  kept  " << kept[i];
  }
}

}  // namespace boxprobe::test
