// See command_runs.h.
#include "tests/documents/command_runs.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/cli/program.h"
#include "tests/documents/command_checks.h"

namespace boxprobe::test {

namespace fs = std::filesystem;

namespace {

constexpr double kManyInputs = 1e6;  // of a stress test: about two seconds

std::string valueOf(const Command& command, const std::string& flag) {
  const auto& words = command.arguments;
  const auto at = std::find(words.begin(), words.end(), flag);
  return at == words.end() || at + 1 == words.end() ? std::string() : *(at + 1);
}

bool has(const Command& command, const std::string& flag) {
  return std::find(command.arguments.begin(), command.arguments.end(), flag) != command.arguments.end();
}

bool isGenerator(const Command& command) {
  return command.kind == CommandKind::Built && fs::path(command.name).filename() == "generate_scenes";
}

bool isEmptyFolder(const fs::path& path) {
  return !fs::exists(path) || (fs::is_directory(path) && fs::is_empty(path)) ||
         (fs::is_regular_file(path) && fs::file_size(path) == 0);
}

std::string runGenerator(const Command& command, const std::string& folder) {
  std::string line = BOXPROBE_GENERATOR;
  // The first argument is where it writes.
  line += " '" + folder + "' >/dev/null";
  if (command.arguments.size() != 1) return "more arguments than this test runs it with";
  if (std::system(line.c_str()) != 0) return line + " failed";
  return fs::exists(folder + "/building.glb") ? "" : "no building.glb written";
}

}  // namespace

bool isCheap(const Command& command) {
  if (!command.example) return false;
  if (isGenerator(command)) return command.arguments.size() == 1;
  if (command.kind != CommandKind::Program) return false;
  const std::string subcommand = subcommandOf(command);
  if (subcommand == "info" || subcommand == "explain" || subcommand == "bake") return true;
  if (subcommand == "render") return valueOf(command, "--technique").rfind("reference-", 0) != 0;
  if (subcommand == "stress") {
    // Whole scenes are slow, and stress_test runs some of them.
    return std::atof(valueOf(command, "--count").c_str()) <= kManyInputs && !has(command, "--device") &&
           valueOf(command, "--class") != "extreme-scenes";
  }
  if (subcommand == "lessons") {
    const bool named = command.arguments.size() > 1 && command.arguments[1][0] != '-';
    return command.arguments.size() == 1 || (named && has(command, "-o"));
  }
  return false;
}

std::string runCommand(const Command& command, const std::string& folder) {
  if (isGenerator(command)) return runGenerator(command, folder);
  std::vector<std::string> words = command.arguments;
  if (subcommandOf(command) == "bake" && std::none_of(words.begin(), words.end(), namesOutput)) {
    words.insert(words.end(), {"-o", "probes"});  // else beside the scene
  }
  std::vector<fs::path> outputs;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (!namesOutput(words[i])) continue;
    outputs.push_back(fs::path(folder) / fs::path(words[i + 1]).filename());
    words[i + 1] = outputs.back().string();
  }
  const Outcome outcome = runProgram(words);
  if (outcome.exitStatus != 0) return "exit status " + std::to_string(outcome.exitStatus) + ": " + outcome.err;
  for (const fs::path& output : outputs) {
    if (isEmptyFolder(output)) return output.filename().string() + " was not written";
  }
  if (outputs.empty() && outcome.out.empty()) return "nothing printed";
  return "";
}

}  // namespace boxprobe::test
