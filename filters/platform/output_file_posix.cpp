// See output_file.h.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "filters/platform/output_file.h"

namespace boxprobe {

namespace {

Flushed flushed(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return Flushed::NotOpened;
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  // Some file systems (pipes, a few network ones) have nothing to flush and return EINVAL: not an error.
  if (result == 0 || reason == EINVAL) return Flushed::Done;
  errno = reason;
  return Flushed::Failed;
}

}  // namespace

NewFile::NewFile(const std::string& path, Access access)
    : descriptor_(
          ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, access == Access::UserAlone ? 0600 : 0666)) {}

NewFile::~NewFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool NewFile::write(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(descriptor_, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool storeName(const std::string& path, const std::string& name) {
  if (::symlink(name.c_str(), path.c_str()) == 0) return true;
  if (errno == ENOENT || errno == EEXIST) return false;
  NewFile file(path, Access::UserAlone);
  return file.isOpen() && file.write(name.data(), name.size());
}

std::string storedName(const std::string& path) {
  char text[1024];
  ssize_t size = ::readlink(path.c_str(), text, sizeof text);
  if (size < 0) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0) {
      size = ::read(descriptor, text, sizeof text);
      ::close(descriptor);
    }
  }
  return {text, static_cast<std::size_t>(size > 0 ? size : 0)};
}

void copyPermissions(const std::string& from, const std::string& to) {
  struct stat old = {};
  if (::stat(from.c_str(), &old) == 0) ::chmod(to.c_str(), old.st_mode & 07777);
}

Flushed flushFile(const std::string& path) {
  return flushed(path, 0);
}

Flushed flushFolder(const std::string& path) {
  return flushed(path, O_DIRECTORY);
}

bool replaceFile(const std::string& from, const std::string& to) {
  return ::rename(from.c_str(), to.c_str()) == 0;
}

bool removeFile(const char* path) noexcept {
  return ::unlink(path) == 0;
}

bool removeEmptyFolder(const char* path) noexcept {
  return ::rmdir(path) == 0;
}

}  // namespace boxprobe
