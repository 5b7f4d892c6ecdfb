// A command that a document shows, taken apart as a shell does it, and what kind of command it is. For tests/documents
// alone; runs nothing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/documents/readme_files.h"

namespace boxprobe::test {

enum class CommandKind {
  Unknown,
  Setup,    ///< ./run, ./run tests
  Program,  ///< boxprobe, or ./run with its arguments
  Built,    ///< another program of build/release
  Fuzzer,   ///< of build/release/fuzz
  CMake,    ///< cmake, ctest
  Ninja,
  Script,  ///< tests/.../NAME.sh
};

struct Command {
  Place place;
  CommandKind kind = CommandKind::Unknown;
  std::string name;                    ///< the program as it is written
  std::vector<std::string> arguments;  ///< after it
  std::map<std::string, std::string> environment;
  bool example = false;  ///< a line of an `sh` block without placeholders: what a reader types
};

/// The words of one line: quotes removed, a comment left out.
std::vector<std::string> shellWords(const std::string& line);

/// SCENE, N, [NAME], FIELD=VALUE...: stands for something in a document.
bool isPlaceholder(const std::string& word);

/// One line of a block.
Command commandOf(const Place& place, const std::string& line);

/// Every command of a document: all lines of its `sh` blocks, and what stands in `backquotes` and begins as a command
/// does (never an example).
std::vector<Command> commandsOf(const Readme& readme);

}  // namespace boxprobe::test
