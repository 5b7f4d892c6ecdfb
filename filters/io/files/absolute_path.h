// Paths that outlive a call, or go to another process, must not depend on the working directory.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace boxprobe {

/// `path` as an absolute path without "." and ".."; links are not resolved. An empty path, or one whose folder no
/// longer exists, stays.
inline std::string absolutePath(const std::string& path) {
  if (path.empty()) return path;
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  return error ? path : whole.lexically_normal().string();
}

}  // namespace boxprobe
