// The include lines of filters/ and app/ and the order of their rooms, as filters/rooms.txt has it. For tests/house
// alone; knows nothing of what the files say.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace boxprobe::test {

struct IncludeLine {
  std::string file;  ///< relative to the root
  int line = 0;
  std::string included;  ///< relative to the root
  std::string place() const { return file + ":" + std::to_string(line); }
};

struct SourceFile {
  std::string path;                         ///< relative to the root
  std::vector<std::string> systemIncludes;  ///< names between < and >
};

struct Rooms {
  std::vector<std::string> lines;                ///< of rooms.txt, one a room, lowest first
  std::map<std::string, int> rank;               ///< by folder; a larger one may include a smaller one
  std::vector<std::vector<std::string>> beside;  ///< folders that do not include each other
};

/// The folder of a path, without a slash at its end.
std::string folderOf(const std::string& path);
/// The path without its extension: a header and its source file are one unit.
std::string unitOf(const std::string& path);

Rooms readRooms(const std::string& root);
/// All .h and .cpp files under filters/ and app/.
std::vector<SourceFile> sourceFiles(const std::string& root);
/// Their includes of files under filters/ and app/.
std::vector<IncludeLine> includeLines(const std::string& root);

/// Breaches of the order, one line each, beginning with file and line.
std::vector<std::string> breaches(const Rooms& rooms, const std::vector<IncludeLine>& includes);
/// Circles of units, each as "a -> b -> a".
std::vector<std::string> circles(const std::vector<IncludeLine>& includes);

}  // namespace boxprobe::test
