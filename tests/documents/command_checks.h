// Is a command of a document still right? Checked by what it names: programs, flags, values, tests, scenes, files. The
// cheap ones are run as well, by command_runs.h. For tests/documents alone.
#pragma once

#include <string>
#include <vector>

#include "tests/documents/built_programs.h"
#include "tests/documents/command_line.h"

namespace boxprobe::test {

class CommandChecks {
 public:
  /// `root`: the source tree, also the current folder; `programs`: what the build makes.
  CommandChecks(std::string root, std::vector<BuiltProgram> programs);

  /// Empty, or one sentence each of what the command names and is not there.
  std::vector<std::string> problems(const Command& command) const;

 private:
  std::vector<std::string> setupProblems(const Command& command) const;
  std::vector<std::string> programProblems(const Command& command) const;
  std::vector<std::string> builtProblems(const Command& command) const;
  std::vector<std::string> cmakeProblems(const Command& command) const;
  std::vector<std::string> ninjaProblems(const Command& command) const;
  std::vector<std::string> scriptProblems(const Command& command) const;
  bool builds(const std::string& target) const;
  bool exists(const std::string& path) const;

  std::string root_;
  std::vector<BuiltProgram> programs_;
};

/// The sub-command of a call of boxprobe, empty for the window.
std::string subcommandOf(const Command& command);

/// -o and --stats: what the command writes.
bool namesOutput(const std::string& flag);

/// `--flag` of `--flag=value`; empty for what is no flag (a negative number is none).
std::string flagOf(const std::string& argument);

}  // namespace boxprobe::test
