// Lines of words and numbers that a test finds, against those that a file below tests/ keeps. After a change that is
// wanted, BOXPROBE_WRITE_VALUES=1 writes the file anew; read what differs before it is committed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace boxprobe::test {

/// So many significant digits; what is nothing beside 1 is 0, whatever its sign.
inline std::string keptNumber(double value, int digits = 6) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, std::abs(value) < 1e-7 ? 0.0 : value);
  return text;
}

/// Each with a space before it.
template <typename... Values>
std::string keptNumbers(Values... values) {
  std::string text;
  ((text += " " + keptNumber(static_cast<double>(values))), ...);
  return text;
}

template <typename Vector>
std::string keptVector(const Vector& v, int digits = 6) {
  return keptNumber(v[0], digits) + " " + keptNumber(v[1], digits) + " " + keptNumber(v[2], digits);
}

/// The length of the number that begins there; 0: none does.
inline std::size_t numberAhead(const std::string& text, std::size_t at) {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  const auto inWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (at > 0 && inWord(text[at - 1])) return 0;
  std::size_t end = at;
  if (text[end] == '-' || text[end] == '+') ++end;
  if (!digit(end)) return 0;
  while (digit(end)) ++end;
  if (end < text.size() && text[end] == '.' && digit(end + 1)) {
    while (digit(++end)) {
    }
  }
  if (end + 2 < text.size() && text[end] == 'e' && (text[end + 1] == '-' || text[end + 1] == '+')) {
    for (end += 2; digit(end);) ++end;
  }
  return end - at;
}

/// The same words and whole numbers. Other numbers may be off by `tolerance` of their size, or of a tenth if they are
/// smaller: compilers and C libraries round differently. Spaces that align columns count as one.
inline bool sameKeptLine(const std::string& a, const std::string& b, double tolerance) {
  const auto skipped = [](const std::string& text, std::size_t at) {
    while (at < text.size() && text[at] == ' ') ++at;
    return at;
  };
  std::size_t i = 0, j = 0;
  while (true) {
    i = skipped(a, i);
    j = skipped(b, j);
    if (i >= a.size() || j >= b.size()) return i >= a.size() && j >= b.size();
    const std::size_t left = numberAhead(a, i), right = numberAhead(b, j);
    if (left == 0 || right == 0) {
      if (a[i++] != b[j++]) return false;
      continue;
    }
    const std::string x = a.substr(i, left), y = b.substr(j, right);
    if (x != y) {
      const bool fraction = (x + y).find_first_of(".e") != std::string::npos;
      const double u = std::strtod(x.c_str(), nullptr), v = std::strtod(y.c_str(), nullptr);
      if (!fraction || !(std::abs(u - v) <= tolerance * std::max({std::abs(u), std::abs(v), 0.1}))) return false;
    }
    i += left;
    j += right;
  }
}

constexpr double kExactly = 0.0;

/// `name`: of the file, as in "unit/values/gltf.txt".
inline std::string keptPath(const std::string& name) {
  return std::string(BOXPROBE_SOURCE_DIR) + "/tests/" + name;
}

/// Whether the environment wants the file written anew; then it is.
inline bool writesKept(const std::string& name, const std::vector<std::string>& lines) {
  if (std::getenv("BOXPROBE_WRITE_VALUES") == nullptr) return false;
  std::ofstream file(keptPath(name));
  for (const std::string& line : lines) file << line << '\n';
  EXPECT_TRUE(file.flush()) << name;
  return true;
}

inline std::vector<std::string> keptLines(const std::string& name) {
  std::ifstream file(keptPath(name));
  EXPECT_TRUE(file) << name;
  std::vector<std::string> kept;
  for (std::string line; std::getline(file, line);) kept.push_back(line);
  return kept;
}

/// A line that begins with "== " is the title of those that follow.
inline void expectKeptValues(const std::string& name, const std::vector<std::string>& lines, double tolerance = 1e-4) {
  if (writesKept(name, lines)) return;
  const std::vector<std::string> kept = keptLines(name);
  EXPECT_EQ(lines.size(), kept.size()) << name;
  std::string title;
  int wrong = 0;  // what follows may be the same lines further on
  for (std::size_t i = 0; i < std::min(lines.size(), kept.size()) && wrong < 20; ++i) {
    if (kept[i].rfind("== ", 0) == 0) title = kept[i];
    if (sameKeptLine(lines[i], kept[i], tolerance)) continue;
    ADD_FAILURE() << name << ":" << i + 1 << " " << title << "\n  found " << lines[i] << "\n  kept  " << kept[i];
    ++wrong;
  }
}

/// Such lines as they are gathered.
class KeptValues {
 public:
  void part(const std::string& title) { lines_.push_back("== " + title); }
  /// Each line of the text.
  void add(const std::string& text) {
    std::istringstream rows(text);
    for (std::string row; std::getline(rows, row);) lines_.push_back(row);
  }
  void add(const std::string& label, const std::vector<double>& values) {
    std::string row = label;
    for (const double value : values) row += " " + keptNumber(value, 7);
    lines_.push_back(row);
  }
  template <typename Number>
  void add(const std::string& label, const std::vector<Number>& values) {
    add(label, std::vector<double>(values.begin(), values.end()));
  }
  /// Of each of four channels: the mean, each texel with another weight, so that no two may change places.
  void addTexels(const std::string& label, const float* rgba, std::size_t texels) {
    std::vector<double> sums(4, 0.0);
    for (std::size_t i = 0; i < 4 * texels; ++i) {
      sums[i % 4] += static_cast<double>(rgba[i]) * (1.0 + static_cast<double>(i / 4 * 7919 % 97) / 97.0);
    }
    for (double& sum : sums) sum /= static_cast<double>(texels);
    add(label, sums);
  }
  /// Of nlohmann's kinds: a line for each value and each list of numbers, with its path.
  template <typename Json>
  void addJson(const std::string& path, const Json& json) {
    const bool list = json.is_array() && !json.empty() &&
                      std::all_of(json.begin(), json.end(), [](const Json& value) { return value.is_number(); });
    if (json.is_number()) return add(path, std::vector<double>{json.template get<double>()});
    if (list) return add(path, json.template get<std::vector<double>>());
    if (!json.is_structured() || json.empty()) return add(path + " " + json.dump());
    for (const auto& [key, value] : json.items()) addJson(path + "/" + key, value);
  }

  const std::vector<std::string>& lines() const { return lines_; }
  void expect(const std::string& name, double tolerance = 1e-4) const { expectKeptValues(name, lines_, tolerance); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace boxprobe::test
