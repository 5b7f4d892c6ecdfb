#include "filters/io/files/data_folder.h"

#include <filesystem>

#include "filters/platform/process.h"

namespace boxprobe {

namespace fs = std::filesystem;

std::string dataFile(const std::string& below) {
  std::error_code unknown;
  const fs::path program = programPath();
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path()) {
    const fs::path data = at / "share/boxprobe";
    if (fs::is_directory(data, unknown)) return fs::weakly_canonical(data / below, unknown).string();
  }
  return (program.parent_path().parent_path() / "share/boxprobe" / below).string();
}

}  // namespace boxprobe
