// Temporary file, flush, rename; see the header. POSIX calls because the standard library cannot flush to disk.
#include "filters/io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/io/files/temporary_file.h"

namespace boxprobe {

namespace {

[[noreturn]] void failed(const std::string& path, const std::string& what) {
  throw WorkError(path + ": " + what + ": " + std::strerror(errno));
}

/// Beside the target, so that the rename stays on one file system; it keeps the extension, which writers may look at.
std::string temporaryName(const std::filesystem::path& target) {
  static std::atomic<unsigned> next{0};
  const std::string unique = std::to_string(::getpid()) + "-" + std::to_string(next++);
  return (target.parent_path() / ("." + target.stem().string() + "." + unique + target.extension().string())).string();
}

/// One that a process which was killed left behind for the same target? (".room.1234-0.exr" for "room.exr")
bool isTemporaryOf(const std::filesystem::path& target, const std::string& name) {
  const std::string start = "." + target.stem().string() + ".", end = target.extension().string();
  if (name.size() <= start.size() + end.size() || name.compare(0, start.size(), start) != 0) return false;
  if (name.compare(name.size() - end.size(), end.size(), end) != 0) return false;
  const std::string unique = name.substr(start.size(), name.size() - start.size() - end.size());
  const std::size_t dash = unique.find('-');
  return dash != std::string::npos && dash > 0 && dash + 1 < unique.size() &&
         unique.find_first_not_of("0123456789-") == std::string::npos &&
         unique.find('-', dash + 1) == std::string::npos;
}

/// Whoever writes one holds a lock on it, which ends with its process: one that can be locked has no writer any more.
void removeLeftovers(const std::filesystem::path& target, const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (!isTemporaryOf(target, it->path().filename().string())) continue;
    const int descriptor = ::open(it->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(it->path().c_str());
    ::close(descriptor);
  }
}

/// Owns the name, and a lock on the file, until the rename: removes the file if that never happens.
class Temporary {
 public:
  explicit Temporary(const std::string& name) : name_(name) {}
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  /// Exclusively; false if that is not possible here.
  bool create() {
    descriptor_ = ::open(name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      name_.release();  // it is not ours to remove
      return false;
    }
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // a file system without locks has no leftovers removed, that is all
    return true;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const std::string& name() const { return name_.name(); }
  void release() { name_.release(); }

 private:
  TemporaryName name_;
  int descriptor_ = -1;
};

void flush(const std::string& file, int flags, const std::string& path) {
  const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) failed(path, "cannot reopen what was written");
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  // Some file systems (pipes, a few network ones) have nothing to flush and say EINVAL: that is no failure.
  if (result != 0 && reason != EINVAL) {
    errno = reason;
    failed(path, "cannot flush to disk");
  }
}

}  // namespace

std::string writtenPath(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;  // as many as Linux follows
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = target.parent_path() / next;  // an absolute one takes the place of all
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

  removeLeftovers(target, folder);
  Temporary temporary(temporaryName(target));
  // Made here, exclusively, so that a folder one may not write to is named as such, not by whatever library writes.
  if (!temporary.create()) failed(path, "cannot write in its folder");
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
