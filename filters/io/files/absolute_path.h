// Paths that are kept - beyond this call, or by another process - must not depend on where it was started.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace boxprobe {

/// `path` from the root, without "." and "..", links as they are; an empty path, or one whose folder is gone, stays.
inline std::string absolutePath(const std::string& path) {
  if (path.empty()) return path;
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  return error ? path : whole.lexically_normal().string();
}

}  // namespace boxprobe
