// The programs that the build makes, and what their sources hold: so that a command can be checked without being run,
// and without its program having been built. For tests/documents alone.
#pragma once

#include <string>
#include <vector>

namespace boxprobe::test {

struct BuiltProgram {
  std::string path;                  ///< in the build folder: "tests/image/mirror_test"
  std::vector<std::string> sources;  ///< absolute
};

/// From the list that tests/documents/CMakeLists.txt writes: a line `PATH|SOURCE;SOURCE...` for each program.
std::vector<BuiltProgram> readBuiltPrograms(const std::string& listFile);

/// Null if there is none of that path in the build folder.
const BuiltProgram* findProgram(const std::vector<BuiltProgram>& programs, const std::string& path);

/// Does a source hold the text as a literal of its own, "--size"?
bool holdsLiteral(const BuiltProgram& program, const std::string& text);

/// SUITE.NAME of every GoogleTest case in the sources.
std::vector<std::string> testNames(const BuiltProgram& program);

/// As --gtest_filter reads it: * is any text, : separates patterns. No negative patterns.
bool filterMatches(const std::string& filter, const std::string& testName);

}  // namespace boxprobe::test
