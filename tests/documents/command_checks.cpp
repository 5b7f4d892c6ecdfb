// See command_checks.h.
#include "tests/documents/command_checks.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "filters/math/technique/technique_table.h"
#include "tests/cli/program.h"

namespace boxprobe::test {

namespace fs = std::filesystem;

namespace {

const std::set<std::string> kSubcommands = {"render",  "explain", "info",   "bake", "bench", "stress",
                                            "lessons", "export",  "import", "fit",  "place", "report"};

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

bool helpNames(const std::string& help, const std::string& flag) {
  return std::regex_search(help, std::regex("(^|[\\s,])" + flag + "($|[\\s,:=])"));
}

bool isReference(const std::string& technique) {
  return technique == "reference-box" || technique == "reference-scene" || technique == "reference-path";
}

/// Asked for once: there are many commands and few helps.
const std::string& helpOf(const std::string& subcommand) {
  static std::map<std::string, std::string> known;
  const auto [help, added] = known.emplace(subcommand, "");
  if (added) {
    std::vector<std::string> call = {"--help"};
    if (!subcommand.empty()) call.insert(call.begin(), subcommand);
    help->second = runProgram(call, DisplayKind::Unset).out;
  }
  return help->second;
}

/// One id, or several with commas and settings: box,raytraced:samples=16.
std::string unknownTechnique(const std::string& list) {
  std::istringstream ids(list);
  for (std::string id; std::getline(ids, id, ',');) {
    id = id.substr(0, id.find(':'));
    if (!isReference(id) && id != "halved" && !parseTechnique(id)) return id;
  }
  return "";
}

/// A word that stands for nothing and is a path of this tree.
bool looksLikeInput(const std::string& word) {
  return !isPlaceholder(word) && word.rfind("data/", 0) == 0;
}

}  // namespace

std::string flagOf(const std::string& argument) {
  static const std::regex pattern("(--?[a-z][a-z_-]*)(=.*)?");
  std::smatch match;
  return std::regex_match(argument, match, pattern) ? match[1].str() : std::string();
}

bool namesOutput(const std::string& flag) {
  return flag == "-o" || flag == "--output" || flag == "--stats";
}

std::string subcommandOf(const Command& command) {
  const auto& words = command.arguments;
  return !words.empty() && kSubcommands.count(words[0]) != 0 ? words[0] : std::string();
}

CommandChecks::CommandChecks(std::string root, std::vector<BuiltProgram> programs)
    : root_(std::move(root)), programs_(std::move(programs)) {}

bool CommandChecks::exists(const std::string& path) const {
  return fs::exists(fs::path(root_) / path);
}

std::vector<std::string> CommandChecks::problems(const Command& command) const {
  switch (command.kind) {
    case CommandKind::Setup:
      return setupProblems(command);
    case CommandKind::Program:
      return programProblems(command);
    case CommandKind::Built:
      return builtProblems(command);
    case CommandKind::Fuzzer: {
      const std::string kind = fs::path(command.name).filename().string().substr(std::string("fuzz_").size());
      if (exists("tests/fuzz/" + kind + "_target.cpp")) return {};
      return {"no fuzzer of " + kind};
    }
    case CommandKind::CMake:
      return cmakeProblems(command);
    case CommandKind::Ninja:
      return ninjaProblems(command);
    case CommandKind::Script:
      return scriptProblems(command);
    case CommandKind::Unknown:
      break;
  }
  return {"no command that this test knows: " + command.name};
}

std::vector<std::string> CommandChecks::setupProblems(const Command& command) const {
  const std::string text = readFile(root_ + "/run");
  if (command.arguments.empty()) return {};
  // The usage that the script prints, and the branch that does it.
  if (text.find("\n./run " + command.arguments[0] + " ") == std::string::npos) {
    return {"run does not explain " + command.arguments[0]};
  }
  return {};
}

std::vector<std::string> CommandChecks::programProblems(const Command& command) const {
  std::vector<std::string> problems;
  const std::string subcommand = subcommandOf(command);
  const std::string& help = helpOf(subcommand);
  for (std::size_t i = subcommand.empty() ? 0 : 1; i < command.arguments.size(); ++i) {
    const std::string& word = command.arguments[i];
    const std::string flag = flagOf(word);
    const std::string value = i + 1 < command.arguments.size() ? command.arguments[i + 1] : "";
    if (!flag.empty() && !helpNames(help, flag))
      problems.push_back(joined({"boxprobe ", subcommand, " has no ", flag}));
    if ((flag == "--technique" || flag == "--techniques") && !isPlaceholder(value) && !value.empty()) {
      const std::string unknown = unknownTechnique(value);
      if (!unknown.empty()) problems.push_back("no technique " + unknown);
    }
    if (looksLikeInput(word) && !exists(word)) problems.push_back("no file " + word);
  }
  const bool named = subcommand == "lessons" && command.arguments.size() > 1 && flagOf(command.arguments[1]).empty();
  if (named && !isPlaceholder(command.arguments[1])) {
    const std::string list = runProgram({"lessons"}, DisplayKind::Unset).out;
    if (list.find("  " + command.arguments[1] + " ") == std::string::npos) {
      problems.push_back("no lesson " + command.arguments[1]);
    }
  }
  // Values: the program checks them before it prints its help.
  if (command.example && problems.empty()) {
    std::vector<std::string> checked = command.arguments;
    checked.emplace_back("--help");
    const Outcome outcome = runProgram(checked, DisplayKind::Unset);
    if (outcome.exitStatus != 0) problems.push_back(outcome.err);
  }
  return problems;
}

std::vector<std::string> CommandChecks::builtProblems(const Command& command) const {
  const std::string path = command.name.substr(std::string("build/release/").size());
  const BuiltProgram* program = findProgram(programs_, path);
  if (program == nullptr) return {"the build makes no " + path};
  std::vector<std::string> problems;
  for (const auto& [name, ignored] : command.environment) {
    if (!holdsLiteral(*program, name)) problems.push_back(joined({path, " does not read ", name}));
  }
  bool value = false;
  for (const std::string& word : command.arguments) {
    const std::string flag = flagOf(word);
    if (flag == "--gtest_filter") {
      const std::vector<std::string> names = testNames(*program);
      const std::string filter = word.substr(word.find('=') + 1);
      if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return filterMatches(filter, name); })) {
        problems.push_back(joined({path, " has no test ", filter}));
      }
    } else if (!flag.empty()) {
      if (!holdsLiteral(*program, flag)) problems.push_back(joined({path, " has no ", flag}));
      value = word.find('=') == std::string::npos;
      continue;
    } else if (!value && !isPlaceholder(word) && word.find_first_not_of("0123456789") != std::string::npos) {
      if (!exists(word) && !holdsLiteral(*program, word)) problems.push_back(joined({path, " does not know ", word}));
    }
    value = false;
  }
  return problems;
}

bool CommandChecks::builds(const std::string& target) const {
  // What is built beside programs: the site, the Python module.
  for (const char* list : {"app/site/CMakeLists.txt", "filters/vtk/python/CMakeLists.txt"}) {
    const std::string text = readFile(root_ + "/" + list);
    if (text.find("add_custom_target(" + target + "\n") != std::string::npos) return true;
    if (text.find("pybind11_add_module(" + target + " ") != std::string::npos) return true;
  }
  return std::any_of(programs_.begin(), programs_.end(),
                     [&](const BuiltProgram& program) { return fs::path(program.path).filename() == target; });
}

std::vector<std::string> CommandChecks::ninjaProblems(const Command& command) const {
  std::vector<std::string> problems;
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    if (command.arguments[i] == "-C") {
      ++i;  // the folder
    } else if (flagOf(command.arguments[i]).empty() && !builds(command.arguments[i])) {
      problems.push_back("no program " + command.arguments[i]);
    }
  }
  return problems;
}

std::vector<std::string> CommandChecks::scriptProblems(const Command& command) const {
  const std::string path = root_ + "/" + command.name;
  if (access(path.c_str(), X_OK) != 0) return {"no script " + command.name};
  const std::string text = readFile(path);
  std::vector<std::string> problems;
  for (const std::string& word : command.arguments) {
    const std::string flag = flagOf(word);
    if (!flag.empty() && text.find(flag) == std::string::npos) {
      problems.push_back(joined({command.name, " has no ", flag}));
    }
  }
  return problems;
}

std::vector<std::string> CommandChecks::cmakeProblems(const Command& command) const {
  std::ifstream in(root_ + "/CMakePresets.json");
  const nlohmann::json presets = nlohmann::json::parse(in);
  const bool build = !command.arguments.empty() && command.arguments[0] == "--build";
  const char* kind = command.name == "ctest" ? "testPresets" : build ? "buildPresets" : "configurePresets";
  bool known = false;
  std::vector<std::string> problems;
  for (std::size_t i = 0; i + 1 < command.arguments.size(); ++i) {
    // What is installed is a preset's build folder.
    const bool install = command.arguments[i] == "--install";
    const std::string value = install && command.arguments[i + 1].rfind("build/", 0) == 0
                                  ? fs::path(command.arguments[i + 1]).filename().string()
                                  : command.arguments[i + 1];
    if (install || command.arguments[i] == "--preset") {
      for (const auto& preset : presets.at(kind)) known |= preset.at("name") == value;
    }
    if (command.arguments[i] == "-R" && !builds(value)) {
      problems.push_back("no test " + value);
    }
  }
  if (!known) problems.push_back("no preset of CMakePresets.json");
  return problems;
}

}  // namespace boxprobe::test
