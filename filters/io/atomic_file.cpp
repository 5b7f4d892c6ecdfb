// Temporary file, flush, rename; see the header. POSIX calls because the standard library cannot flush to disk.
#include "filters/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "filters/core/errors.h"

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

/// Owns the name until the rename: removes the file if that never happens.
class Temporary {
 public:
  explicit Temporary(std::string name) : name_(std::move(name)) {}
  ~Temporary() {
    if (!released_) ::unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const std::string& name() const { return name_; }
  void release() { released_ = true; }

 private:
  std::string name_;
  bool released_ = false;
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

void writeAtomically(const std::string& path, const std::function<void(const std::string&)>& write) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  // A symbolic link stays one: what it points at is replaced.
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(target, ignored))) {
    const fs::path resolved = fs::weakly_canonical(target, ignored);
    if (!ignored && !resolved.empty()) target = resolved;
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (target.filename().empty() || fs::is_directory(target, ignored)) {
    throw WorkError(path + ": is a folder; name a file in it");
  }
  if (!fs::is_directory(folder, ignored)) {
    throw WorkError(path + ": the folder " + folder.string() + " does not exist; make it first");
  }

  Temporary temporary(temporaryName(target));
  // Made here, exclusively, so that a folder one may not write to is named as such, not by whatever library writes.
  const int descriptor = ::open(temporary.name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) failed(path, "cannot write in its folder");
  ::close(descriptor);
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
