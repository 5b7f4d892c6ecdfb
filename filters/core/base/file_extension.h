// What kind of file a name says it is. Called by readers and by commands that write.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace boxprobe {

/// With its dot, in small letters: ".exr" of "Sky.EXR"; "" without one.
inline std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace boxprobe
