// See built_programs.h.
#include "tests/documents/built_programs.h"

#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/cli/program.h"

namespace boxprobe::test {

std::vector<BuiltProgram> readBuiltPrograms(const std::string& listFile) {
  std::vector<BuiltProgram> programs;
  std::ifstream in(listFile);
  for (std::string line; std::getline(in, line);) {
    const std::size_t bar = line.find('|');
    if (bar == std::string::npos) continue;
    BuiltProgram program{line.substr(0, bar), {}};
    std::istringstream sources(line.substr(bar + 1));
    for (std::string source; std::getline(sources, source, ';');) program.sources.push_back(source);
    programs.push_back(std::move(program));
  }
  return programs;
}

const BuiltProgram* findProgram(const std::vector<BuiltProgram>& programs, const std::string& path) {
  const auto found = std::find_if(programs.begin(), programs.end(), [&](const auto& p) { return p.path == path; });
  return found == programs.end() ? nullptr : &*found;
}

bool holdsLiteral(const BuiltProgram& program, const std::string& text) {
  return std::any_of(program.sources.begin(), program.sources.end(), [&](const std::string& source) {
    return readFile(source).find('"' + text + '"') != std::string::npos;
  });
}

std::vector<std::string> testNames(const BuiltProgram& program) {
  static const std::regex pattern(R"(\nTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::vector<std::string> names;
  for (const std::string& source : program.sources) {
    const std::string text = readFile(source);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      names.push_back((*it)[1].str() + "." + (*it)[2].str());
    }
  }
  return names;
}

bool filterMatches(const std::string& filter, const std::string& testName) {
  std::istringstream patterns(filter);
  for (std::string pattern; std::getline(patterns, pattern, ':');) {
    if (fnmatch(pattern.c_str(), testName.c_str(), 0) == 0) return true;
  }
  return false;
}

}  // namespace boxprobe::test
