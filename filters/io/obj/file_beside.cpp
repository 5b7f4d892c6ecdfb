#include "filters/io/obj/file_beside.h"

#include <algorithm>
#include <filesystem>

#include "filters/io/files/inside_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/io/obj/obj_text.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// The path `name` below `folder` with each part as the disk spells it; empty if there is none.
fs::path spelt(const fs::path& folder, const fs::path& name) {
  fs::path at = folder;
  std::error_code ignored;
  for (const fs::path& part : name) {
    if (fs::exists(at / part, ignored)) {
      at /= part;
      continue;
    }
    const std::string wanted = lowerText(part.string());
    fs::path found;
    for (fs::directory_iterator entry(at.empty() ? "." : at, ignored), end; entry != end; entry.increment(ignored)) {
      if (ignored) break;
      // In the order of names, so that the choice does not depend on the disk.
      const fs::path name_ = entry->path().filename();
      if (lowerText(name_.string()) == wanted && (found.empty() || name_ < found)) found = name_;
    }
    if (found.empty()) return {};
    at /= found;
  }
  return at;
}

}  // namespace

FileBeside fileBeside(const std::string& from, const std::string& name, const std::string& model) {
  constexpr std::size_t kLongestName = 4000;
  FileBeside result;
  if (name.empty() || name.size() > kLongestName) return result;
  const fs::path folder = fs::path(from).parent_path(), modelFolder = fs::path(model).parent_path();
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const fs::path last = fs::path(slashes).filename();
  std::error_code ignored;
  const auto take = [&](const fs::path& path) {
    if (path.empty() || !fs::is_regular_file(path, ignored)) return false;
    if (!insideFolderOf(path.string(), model)) {
      result.outside = true;
      return false;
    }
    result.path = path.string();
    return true;
  };
  if (take(folder / name) || take(folder / slashes)) return result;
  if (fs::path(slashes).is_relative() && take(spelt(folder, slashes))) return result;
  if (!insideFolderOf((folder / slashes).string(), model)) result.outside = true;
  if (!last.empty() && (take(spelt(folder, last)) || take(spelt(modelFolder, last)))) return result;
  if (!result.outside) noteAsked((folder / slashes).string());
  return result;
}

}  // namespace boxprobe
