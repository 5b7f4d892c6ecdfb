// Lines of values that a test finds, against those that a file beside it keeps. After a change that is wanted,
// BOXPROBE_WRITE_VALUES=1 writes the file anew; read what differs before it is committed.
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

namespace boxprobe {

class KeptValues {
 public:
  void add(const std::string& text) {
    std::istringstream rows(text);
    for (std::string row; std::getline(rows, row);) lines_.push_back(row);
  }
  void add(const std::string& label, const std::vector<double>& values) {
    std::string row = label;
    for (const double value : values) {
      char text[40];
      std::snprintf(text, sizeof text, " %.7g", value == 0.0 ? 0.0 : value);
      row += text;
    }
    lines_.push_back(row);
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
    if (json.is_number()) return add(path, {json.template get<double>()});
    if (list) return add(path, json.template get<std::vector<double>>());
    if (!json.is_structured() || json.empty()) return add(path + " " + json.dump());
    for (const auto& [key, value] : json.items()) addJson(path + "/" + key, value);
  }

  /// `name`: of the file in tests/unit.
  void expectKept(const std::string& name) const {
    const std::string path = std::string(BOXPROBE_SOURCE_DIR) + "/tests/unit/" + name;
    if (std::getenv("BOXPROBE_WRITE_VALUES") != nullptr) {
      std::ofstream file(path);
      for (const std::string& line : lines_) file << line << '\n';
      ASSERT_TRUE(file.flush()) << path;
      return;
    }
    std::ifstream file(path);
    ASSERT_TRUE(file) << path;
    std::vector<std::string> kept;
    for (std::string line; std::getline(file, line);) kept.push_back(line);
    EXPECT_EQ(lines_.size(), kept.size());
    for (std::size_t i = 0; i < std::min(lines_.size(), kept.size()); ++i) {
      if (same(lines_[i], kept[i])) continue;
      ADD_FAILURE() << path << ":" << i + 1 << "\n  found: " << lines_[i] << "\n  kept:  " << kept[i];
      return;  // what follows may be the same lines further on
    }
  }

 private:
  static bool startsNumber(const std::string& text, std::size_t at) {
    const auto digit = [&](std::size_t i) {
      return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    const bool inWord = at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '_');
    return !inWord && (digit(at) || (text[at] == '-' && digit(at + 1)));
  }
  /// Equal but for the last digits of fractions: compilers and their levels of optimization round differently, and a
  /// half float may then be its neighbour.
  static bool same(const std::string& a, const std::string& b) {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
      if (!startsNumber(a, i) || !startsNumber(b, j)) {
        if (a[i++] != b[j++]) return false;
        continue;
      }
      char *endA = nullptr, *endB = nullptr;
      const double x = std::strtod(a.c_str() + i, &endA), y = std::strtod(b.c_str() + j, &endB);
      const std::string left = a.substr(i, static_cast<std::size_t>(endA - a.c_str()) - i),
                        right = b.substr(j, static_cast<std::size_t>(endB - b.c_str()) - j);
      const bool fraction = (left + right).find_first_of(".e") != std::string::npos;
      if (fraction ? !(std::fabs(x - y) <= 1e-4 * std::max(std::fabs(x), std::fabs(y)) + 1e-7) : left != right) {
        return false;
      }
      i += left.size();
      j += right.size();
    }
    return i == a.size() && j == b.size();
  }

  std::vector<std::string> lines_;
};

}  // namespace boxprobe
