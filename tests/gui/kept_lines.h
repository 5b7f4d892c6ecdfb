// Lines that a test finds, against those that a file beside it keeps.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace boxprobe {

/// `name`: of the file in tests/gui. If the environment has `variable`, the file is written anew instead.
inline void expectKeptLines(const std::string& name, const char* variable, const std::vector<std::string>& lines) {
  const std::string path = std::string(BOXPROBE_SOURCE_DIR) + "/tests/gui/" + name;
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
  for (std::size_t i = 0; i < std::min(lines.size(), kept.size()); ++i) EXPECT_EQ(lines[i], kept[i]);
}

}  // namespace boxprobe
