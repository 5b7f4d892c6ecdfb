// The kind of a file by its name.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace boxprobe {

/// The extension in lower case with its dot: ".exr" for "Sky.EXR"; "" without one.
inline std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace boxprobe
