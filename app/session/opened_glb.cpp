// See opened_glb.h.
#include "app/session/opened_glb.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/read_file.h"
#include "filters/platform/folders.h"
#include "filters/platform/process.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kDigestLetters = 32;

fs::path cacheFolder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) return fs::path(cache) / "boxprobe" / "glb";
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".cache" / "boxprobe" / "glb";
  return fs::temp_directory_path() / ("boxprobe-" + userText()) / "glb";
}

/// Whoever can write into the folder can put another scene in the place of the one asked for.
void requireOwn(const fs::path& folder) {
  if (!isUsersOwn(folder.string()))
    throw WorkError(folder.string() + ": others can write here; set HOME or XDG_CACHE_HOME");
}

/// Removes what was not opened for a month, and what processes that have ended left half unpacked. Only folders of this
/// file's own names are touched.
void removeOld(const fs::path& cache) {
  std::error_code error;
  const auto month = fs::file_time_type::clock::now() - std::chrono::hours(24 * 30);
  for (fs::directory_iterator it(cache, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.size() < kDigestLetters || name.find_first_not_of("0123456789abcdef.") != std::string::npos) continue;
    std::error_code ignored;
    if (!it->is_directory(ignored)) continue;
    const std::size_t dot = name.find('.');
    const bool left = dot != std::string::npos && !processLives(std::atol(name.c_str() + dot + 1));
    if (left || fs::last_write_time(it->path(), ignored) < month) fs::remove_all(it->path(), ignored);
  }
}

/// Where the file is unpacked, which happens now if it has not.
std::string unpackedFolder(const std::string& path) {
  const fs::path cache = cacheFolder(), folder = cache / ContentHash().add(readWholeFile(path)).text();
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    fs::last_write_time(folder, fs::file_time_type::clock::now(), error);
    return folder.string();
  }
  fs::create_directories(cache, error);
  if (error) throw WorkError(cache.string() + ": cannot create this folder: " + error.message());
  if (fs::is_symlink(fs::symlink_status(cache, error))) {
    throw WorkError(cache.string() + ": is a link; only a folder of this user's own is used, so set XDG_CACHE_HOME");
  }
  fs::permissions(cache, fs::perms::owner_all, error);
  if (error) throw WorkError(cache.string() + ": cannot be kept from others: " + error.message());
  // Below /tmp both folders may be somebody else's.
  requireOwn(cache.parent_path());
  requireOwn(cache);
  removeOld(cache);
  // Beside the place, so that there is a whole folder or none; of two processes one comes too late.
  const fs::path fresh = folder.string() + "." + std::to_string(processNumber());
  fs::remove_all(fresh, error);
  try {
    unpackGlb(path, fresh.string());
    // Somebody may have replaced it between the two readings.
    if (ContentHash().add(readWholeFile(path)).text() != folder.filename().string()) {
      throw WorkError(path + ": changed while it was read; open it again");
    }
  } catch (...) {
    fs::remove_all(fresh, error);
    throw;
  }
  fs::rename(fresh, folder, error);
  if (error) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);
    if (!fs::is_directory(folder, ignored)) throw WorkError(folder.string() + ": cannot be made: " + error.message());
  }
  return folder.string();
}

}  // namespace

Scene openGlbScene(const std::string& path) {
  return glbSceneOf(path, unpackedFolder(path));
}

std::string bakedFolderOf(const std::string& path) {
  if (!holdsProbes(path)) return BakeFolder::besideScene(path);
  return (fs::path(unpackedFolder(path)) / "probes").string();
}

std::string ownPathOf(const std::string& scenePath, const Scene& scene) {
  return scenePath.empty() && !scene.models.empty() ? scene.models.front().file : scenePath;
}

}  // namespace boxprobe
