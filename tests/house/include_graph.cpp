#include "tests/house/include_graph.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace boxprobe::test {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> readLines(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + " cannot be read");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> paths(const std::string& root) {
  std::vector<std::string> found;
  for (const char* top : {"filters", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp") found.push_back(fs::relative(entry.path(), root).generic_string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool within(const std::string& path, const std::string& folder) {
  return path.compare(0, folder.size() + 1, folder + "/") == 0;
}

}  // namespace

std::string folderOf(const std::string& path) {
  return path.substr(0, path.find_last_of('/'));
}

std::string unitOf(const std::string& path) {
  return path.substr(0, path.find_last_of('.'));
}

Rooms readRooms(const std::string& root) {
  Rooms rooms;
  for (const std::string& line : readLines(fs::path(root) / "filters" / "rooms.txt")) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "beside") {
      rooms.beside.emplace_back();
      for (std::string folder; words >> folder;) rooms.beside.back().push_back(folder);
      continue;
    }
    rooms.rank[first] = static_cast<int>(rooms.lines.size());
    rooms.lines.push_back(line);
  }
  return rooms;
}

std::vector<SourceFile> sourceFiles(const std::string& root) {
  static const std::regex system(R"rx(^\s*#include <([^>]+)>.*)rx");
  std::vector<SourceFile> files;
  for (const std::string& path : paths(root)) {
    SourceFile file{path, {}};
    for (const std::string& line : readLines(fs::path(root) / path)) {
      std::smatch match;
      if (std::regex_match(line, match, system)) file.systemIncludes.push_back(match[1]);
    }
    files.push_back(std::move(file));
  }
  return files;
}

std::vector<IncludeLine> includeLines(const std::string& root) {
  static const std::regex own(R"rx(^\s*#include "((?:filters|app)/[^"]+)".*)rx");
  std::vector<IncludeLine> includes;
  for (const std::string& path : paths(root)) {
    int number = 0;
    for (const std::string& line : readLines(fs::path(root) / path)) {
      ++number;
      std::smatch match;
      if (std::regex_match(line, match, own)) includes.push_back({path, number, match[1]});
    }
  }
  return includes;
}

std::vector<std::string> breaches(const Rooms& rooms, const std::vector<IncludeLine>& includes) {
  std::vector<std::string> found;
  const auto rankOf = [&](const std::string& folder) {
    const auto at = rooms.rank.find(folder);
    return at == rooms.rank.end() ? -1 : at->second;
  };
  for (const IncludeLine& include : includes) {
    const std::string from = folderOf(include.file), to = folderOf(include.included);
    if (rankOf(from) < 0) found.push_back(include.place() + ": filters/rooms.txt has no room " + from);
    if (rankOf(to) < 0) found.push_back(include.place() + ": filters/rooms.txt has no room " + to);
    if (rankOf(from) >= 0 && rankOf(to) > rankOf(from)) {
      found.push_back(include.place() + ": " + from + " must not include " + include.included +
                      ", whose room stands further down in filters/rooms.txt");
    }
    for (const std::vector<std::string>& group : rooms.beside) {
      for (const std::string& a : group) {
        for (const std::string& b : group) {
          if (a != b && within(include.file, a) && within(include.included, b)) {
            found.push_back(include.place() + ": " + a + " and " + b + " must not include each other");
          }
        }
      }
    }
  }
  return found;
}

std::vector<std::string> circles(const std::vector<IncludeLine>& includes) {
  std::map<std::string, std::set<std::string>> uses;
  for (const IncludeLine& include : includes) {
    const std::string from = unitOf(include.file), to = unitOf(include.included);
    if (from != to) uses[from].insert(to);
  }
  std::vector<std::string> found;
  std::map<std::string, int> state;  // 1: on the way down, 2: done
  std::vector<std::string> way;
  const std::function<void(const std::string&)> visit = [&](const std::string& unit) {
    state[unit] = 1;
    way.push_back(unit);
    for (const std::string& next : uses[unit]) {
      if (state[next] == 0) visit(next);
      if (state[next] != 1) continue;
      std::string circle;
      for (auto at = std::find(way.begin(), way.end(), next); at != way.end(); ++at) circle += *at + " -> ";
      found.push_back(circle + next);
    }
    way.pop_back();
    state[unit] = 2;
  };
  std::vector<std::string> units;
  for (const auto& [unit, ignored] : uses) units.push_back(unit);
  for (const std::string& unit : units) {
    if (state[unit] == 0) visit(unit);
  }
  return found;
}

}  // namespace boxprobe::test
