// Temporary file, flush, rename. POSIX calls, because the standard library cannot flush to disk.
#include "filters/io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/io/files/temporary_file.h"

namespace boxprobe {

namespace {

[[noreturn]] void failed(const std::string& path, const std::string& what) {
  throw WorkError(path + ": " + what + ": " + std::strerror(errno));
}

constexpr const char* kFolderStart = ".boxprobe-unfinished-";
constexpr const char* kClaim = "claim";
constexpr const char* kClaimStart = "boxprobe-unfinished:";

/// An open folder, closed by the destructor. Its lock ends with the process, even a killed one.
class OpenFolder {
 public:
  explicit OpenFolder(const std::string& name)
      : descriptor_(::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}
  ~OpenFolder() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  bool isOpen() const { return descriptor_ >= 0; }
  bool lock() const { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

 private:
  int descriptor_;
};

/// Records, in one atomic step, which file of the folder is unfinished: as the target of a symbolic link, or in a file
/// where links are not supported.
bool writeClaim(const std::string& claim, const std::string& name) {
  const std::string text = kClaimStart + name;
  if (::symlink(text.c_str(), claim.c_str()) == 0) return true;
  if (errno == ENOENT || errno == EEXIST) return false;
  const int descriptor = ::open(claim.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  const bool written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(descriptor);
  return written;
}

/// The name in a claim; empty if it is not one of this program's.
std::string claimedName(const std::string& claim) {
  char text[1024];
  ssize_t size = ::readlink(claim.c_str(), text, sizeof text);
  if (size < 0) {
    const int descriptor = ::open(claim.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0) {
      size = ::read(descriptor, text, sizeof text);
      ::close(descriptor);
    }
  }
  const std::string said(text, static_cast<std::size_t>(size > 0 ? size : 0)), start = kClaimStart;
  const std::string name = said.compare(0, start.size(), start) == 0 ? said.substr(start.size()) : std::string();
  return name.find('/') == std::string::npos && name != "." && name != ".." ? name : std::string();
}

/// Removes what killed processes left in `folder`: the claim in each of their folders and the file that it names,
/// nothing else.
void removeLeftovers(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().filename().string().rfind(kFolderStart, 0) != 0) continue;
    const OpenFolder left(it->path().string());
    if (!left.isOpen() || !left.lock()) continue;  // not a folder, or its process is alive
    const std::string name = claimedName((it->path() / kClaim).string());
    if (!name.empty()) {
      ::unlink((it->path() / name).c_str());
      ::unlink((it->path() / kClaim).c_str());
    }
    ::rmdir(it->path().c_str());  // fails unless it is empty; a process that has just created it creates another
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
      std::string made = (folder / kFolderStart).string() + "XXXXXX";
      if (::mkdtemp(made.data()) == nullptr) return false;
      folder_.emplace(made);
      lock_.emplace(made);
      if (lock_->isOpen()) {
        lock_->lock();  // without lock support, leftovers of living processes are removed: they fail with an error
        claim_.emplace((std::filesystem::path(made) / kClaim).string());
        if (writeClaim(claim_->name(), name.string())) {
          file_.emplace((std::filesystem::path(made) / name).string());
          const int descriptor = ::open(file_->name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
          if (descriptor < 0) return false;
          ::close(descriptor);
          return true;
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
  std::optional<OpenFolder> lock_;
  std::optional<TemporaryName> claim_, file_;
};

void flush(const std::string& file, int flags, const std::string& path) {
  const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) failed(path, "cannot reopen what was written");
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  // Some file systems (pipes, a few network ones) have nothing to flush and return EINVAL: not an error.
  if (result != 0 && reason != EINVAL) {
    errno = reason;
    failed(path, "cannot flush to disk");
  }
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

void writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path target = writtenPath(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (target.filename().empty() || fs::is_directory(target, ignored)) {
    throw WorkError(path + ": is a folder; name a file in it");
  }
  if (!fs::is_directory(folder, ignored)) {
    throw WorkError(path + ": the folder " + folder.string() + " does not exist; make it first");
  }

  removeLeftovers(folder);
  Unfinished temporary;
  // Created here, exclusively, so that a read-only folder is reported as such and not by the library that writes.
  if (!temporary.create(folder, target.filename())) failed(path, "cannot write in its folder");
  write(temporary.name());

  struct stat old = {};
  if (::stat(target.c_str(), &old) == 0) ::chmod(temporary.name().c_str(), old.st_mode & 07777);
  flush(temporary.name(), O_RDONLY, path);
  if (::rename(temporary.name().c_str(), target.c_str()) != 0) failed(path, "cannot be replaced");
  temporary.release();
  flush(folder.string(), O_RDONLY | O_DIRECTORY, path);  // the rename itself
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
