// See command_line.h.
#include "tests/documents/command_line.h"

#include <algorithm>
#include <regex>
#include <set>

namespace boxprobe::test {

namespace {

bool startsWith(const std::string& text, const std::string& beginning) {
  return text.rfind(beginning, 0) == 0;
}

bool isAssignment(const std::string& word) {
  static const std::regex pattern("[A-Z_]+=.*");
  return std::regex_match(word, pattern);
}

CommandKind kindOf(const std::string& name, const std::vector<std::string>& arguments) {
  static const std::set<std::string> setups = {"tests", "--setup-only", "--help-run"};
  if (name == "./run") {
    return arguments.empty() || setups.count(arguments[0]) != 0 ? CommandKind::Setup : CommandKind::Program;
  }
  if (name == "boxprobe" || name == "build/release/bin/boxprobe") return CommandKind::Program;
  if (startsWith(name, "build/release/fuzz/")) return CommandKind::Fuzzer;
  if (startsWith(name, "build/release/")) return CommandKind::Built;
  if (name == "cmake" || name == "ctest") return CommandKind::CMake;
  if (name == "ninja") return CommandKind::Ninja;
  if (startsWith(name, "tests/") && name.size() > 3 && name.substr(name.size() - 3) == ".sh") {
    return CommandKind::Script;
  }
  return CommandKind::Unknown;
}

}  // namespace

std::vector<std::string> shellWords(const std::string& line) {
  std::vector<std::string> words;
  bool within = false;
  char quote = 0;
  for (const char c : line) {
    if (quote != 0) {
      if (c == quote) {
        quote = 0;
      } else {
        words.back() += c;
      }
    } else if (c == ' ') {
      within = false;
    } else if (c == '#' && !within) {
      break;
    } else {
      if (!within) words.emplace_back();
      within = true;
      if (c == '"' || c == '\'') {
        quote = c;
      } else {
        words.back() += c;
      }
    }
  }
  return words;
}

bool isPlaceholder(const std::string& word) {
  static const std::regex pattern(
      R"(\[?(SCENE|PROGRAM|OLD_BOXPROBE|ARGS|NAME|ID|FILE(\.json)?|FIELD=VALUE|(OUT)?DIR(/.*)?|N|S|X,Y|WxH|LOW,HIGH)\]?(\.\.\.)?)");
  return std::regex_match(word, pattern);
}

Command commandOf(const Place& place, const std::string& line) {
  Command command;
  command.place = place;
  std::vector<std::string> words = shellWords(line);
  command.example = std::none_of(words.begin(), words.end(), isPlaceholder);
  auto word = words.begin();
  for (; word != words.end() && isAssignment(*word); ++word) {
    const std::size_t equals = word->find('=');
    command.environment[word->substr(0, equals)] = word->substr(equals + 1);
  }
  if (word != words.end() && *word == "xvfb-run") {  // the program behind it counts
    for (++word; word != words.end() && startsWith(*word, "-"); ++word) {
      if (*word == "-s" && word + 1 != words.end()) ++word;
    }
  }
  if (word == words.end()) return command;
  command.name = *word++;
  for (; word != words.end(); ++word) {
    // [--seed S] is an argument that may be left out.
    if (word->size() > 1 && word->front() == '[') word->erase(0, 1);
    if (word->size() > 1 && word->back() == ']' && word->find('[') == std::string::npos) word->pop_back();
    command.arguments.push_back(*word);
  }
  command.kind = kindOf(command.name, command.arguments);
  return command;
}

std::vector<Command> commandsOf(const Readme& readme) {
  std::vector<Command> commands;
  for (const CodeBlock& block : codeBlocks(readme)) {
    if (block.language != "sh") continue;
    std::string joined;
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
      joined += block.lines[i];
      if (!joined.empty() && joined.back() == '\\') {
        joined.back() = ' ';
        continue;
      }
      const Place place{block.place.file, block.place.line + static_cast<int>(i)};
      if (!shellWords(joined).empty()) commands.push_back(commandOf(place, joined));
      joined.clear();
    }
  }
  for (const CodeSpan& span : codeSpans(readme)) {
    Command command = commandOf(span.place, span.text);
    command.example = false;
    const bool bare = command.name == "cmake" || command.name == "ctest" || command.name == "boxprobe";
    if (command.kind == CommandKind::Unknown || (bare && command.arguments.empty())) continue;
    commands.push_back(command);
  }
  return commands;
}

}  // namespace boxprobe::test
