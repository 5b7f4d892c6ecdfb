// Temporary file, flush, rename.
#include "filters/io/files/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/io/files/temporary_file.h"
#include "filters/platform/folders.h"
#include "filters/platform/input_file.h"
#include "filters/platform/output_file.h"

namespace boxprobe {

namespace {

[[noreturn]] void failed(const std::string& path, const std::string& what) {
  throw WorkError(path + ": " + what + ": " + std::strerror(errno));
}

constexpr const char* kFolderStart = ".boxprobe-unfinished-";
constexpr const char* kClaim = "claim";
constexpr const char* kClaimStart = "boxprobe-unfinished:";

/// The name in a claim; empty if it is not one of this program's.
std::string claimedName(const std::string& claim) {
  const std::string said = storedName(claim), start = kClaimStart;
  const std::string name = said.compare(0, start.size(), start) == 0 ? said.substr(start.size()) : std::string();
  return name.find('/') == std::string::npos && name != "." && name != ".." ? name : std::string();
}

/// Removes what killed processes left in `folder`: the claim in each of their folders and the file that it names,
/// nothing else.
void removeLeftovers(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().filename().string().rfind(kFolderStart, 0) != 0) continue;
    FolderLock left(it->path().string());
    if (!left.isOpen() || !left.lock()) continue;  // not a folder, or its process is alive
    const std::string name = claimedName((it->path() / kClaim).string());
    if (!name.empty()) {
      removeFile((it->path() / name).string().c_str());
      removeFile((it->path() / kClaim).string().c_str());
    }
    left.remove();  // fails unless it is empty; a process that has just created it creates another
  }
}

/// A file with the target's name in a new folder beside the target, so that the rename stays on one file system. No
/// other process reads that folder. Everything is removed unless the file is renamed.
class Unfinished {
 public:
  /// False, with errno, if it cannot be created here.
  bool create(const std::filesystem::path& folder, const std::filesystem::path& name) {
    constexpr int kTries = 100;  // another process may remove an empty folder as a leftover
    for (int i = 0; i < kTries; ++i) {
      const auto made = makeFolder((folder / kFolderStart).string());
      if (!made) return false;
      folder_.emplace(*made);
      lock_.emplace(*made);
      if (lock_->isOpen()) {
        lock_->lock();  // without lock support, leftovers of living processes are removed: they fail with an error
        claim_.emplace((std::filesystem::path(*made) / kClaim).string());
        if (storeName(claim_->name(), kClaimStart + name.string())) {
          file_.emplace((std::filesystem::path(*made) / name).string());
          return NewFile(file_->name(), Access::AsUsual).isOpen();
        }
      }
      if (errno != ENOENT) return false;
    }
    return false;
  }
  const std::string& name() const { return file_->name(); }
  void release() { file_->release(); }

 private:
  // Destroyed in reverse order: the file, its claim, the folder.
  std::optional<TemporaryName> folder_;
  std::optional<FolderLock> lock_;
  std::optional<TemporaryName> claim_, file_;
};

void requireFlushed(Flushed flushed, const std::string& path) {
  if (flushed == Flushed::NotOpened) failed(path, "cannot reopen what was written");
  if (flushed == Flushed::Failed) failed(path, "cannot flush to disk");
}

}  // namespace

std::string writtenPath(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;  // the limit of Linux
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = target.parent_path() / next;  // an absolute link replaces the whole path
  }
  return target.string();
}

std::string unfinishedFolderName() {
  return std::string(kFolderStart) + "XXXXXX";
}

void writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path target = writtenPath(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (target.filename().empty() || fs::is_directory(target, ignored)) {
    throw WorkError(path + ": is a folder; name a file in it");
  }
  // A rename would put a file in the place of the device.
  if (const auto there = fileStatus(target.string()); there && there->kind == FileStatus::Kind::Other) {
    throw WorkError(path + ": is a pipe or device, not a file; name a file");
  }
  if (fs::is_symlink(fs::symlink_status(target, ignored))) {
    throw WorkError(path + ": its links lead round in a circle; name another file");
  }
  if (!fs::is_directory(folder, ignored)) {
    throw WorkError(path + ": the folder " + folder.string() + " does not exist; make it first");
  }

  removeLeftovers(folder);
  Unfinished temporary;
  // Created here, exclusively, so that a read-only folder is reported as such and not by the library that writes.
  if (!temporary.create(folder, target.filename())) failed(path, "cannot write in its folder");
  write(temporary.name());

  copyPermissions(target.string(), temporary.name());
  requireFlushed(flushFile(temporary.name()), path);
  if (!replaceFile(temporary.name(), target.string())) failed(path, "cannot be replaced");
  temporary.release();
  requireFlushed(flushFolder(folder.string()), path);  // the rename itself
}

void writeTextAtomically(const std::string& path, const std::string& text) {
  writeAtomically(path, [&](const std::string& temporary) {
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (file == nullptr) failed(path, "cannot be opened for writing");
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const int reason = errno;
    const bool closed = std::fclose(file) == 0;
    if (!written) errno = reason;
    if (!written || !closed) failed(path, "cannot be written");
  });
}

}  // namespace boxprobe
