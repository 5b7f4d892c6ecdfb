#include "filters/io/files/inside_folder.h"

#include <algorithm>
#include <filesystem>

namespace boxprobe {

bool insideFolderOf(const std::string& path, const std::string& model) {
  namespace fs = std::filesystem;
  std::error_code error;
  // Absolute first: weakly_canonical() leaves a relative path that does not exist relative.
  const auto whole = [&error](const fs::path& any) { return fs::weakly_canonical(fs::absolute(any, error), error); };
  const fs::path base = whole(fs::absolute(model, error).parent_path());
  if (error) return false;
  const fs::path inner = whole(path);
  if (error) return false;
  return std::mismatch(base.begin(), base.end(), inner.begin(), inner.end()).first == base.end();
}

}  // namespace boxprobe
