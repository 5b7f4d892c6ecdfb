// The scenes of data/scenes, for tests of all of them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace boxprobe::test {

/// Names without ending, sorted.
inline std::vector<std::string> sceneNames() {
  const std::string ending = ".boxprobe.json";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(BOXPROBE_DATA_DIR "/scenes")) {
    const std::string file = entry.path().filename().string();
    if (file.size() > ending.size() && file.substr(file.size() - ending.size()) == ending) {
      names.push_back(file.substr(0, file.size() - ending.size()));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace boxprobe::test
