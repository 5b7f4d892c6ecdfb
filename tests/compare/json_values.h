// The keys and the numbers of a JSON file, for comparing two of them. Knows nothing of what they mean, except by name
// which numbers change from run to run.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace boxprobe::compare {

struct JsonValues {
  std::set<std::string> keys;             ///< paths with indices left out: "probes[].box.min[]"
  std::map<std::string, double> numbers;  ///< by path with indices; true is 1; "measured" texts give all their numbers
};

/// A JSON document, or one document a line. Throws std::runtime_error naming the file.
JsonValues readJson(const std::string& path);

/// The "name" of every object in the list `list` at the top of a document, in order. Throws as readJson does.
std::vector<std::string> namesInJson(const std::string& path, const std::string& list);

/// Is it a time, a memory size of the process, or a ratio of times?
bool changesByRun(const std::string& path);

}  // namespace boxprobe::compare
