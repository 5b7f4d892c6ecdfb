// See input_file.h.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "filters/platform/input_file.h"

namespace boxprobe {

namespace {

FileStatus statusOf(const struct stat& found) {
  FileStatus status;
  status.kind = S_ISDIR(found.st_mode)   ? FileStatus::Kind::Folder
                : S_ISREG(found.st_mode) ? FileStatus::Kind::File
                                         : FileStatus::Kind::Other;
  status.size = static_cast<std::uint64_t>(found.st_size);
  status.identity = {static_cast<std::uint64_t>(found.st_dev), static_cast<std::uint64_t>(found.st_ino)};
  return status;
}

}  // namespace

std::optional<FileStatus> fileStatus(const std::string& path) {
  struct stat found = {};
  if (::stat(path.c_str(), &found) != 0) return {};
  return statusOf(found);
}

InputFile::InputFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<FileStatus> InputFile::status() const {
  struct stat found = {};
  if (::fstat(descriptor_, &found) != 0) return {};
  return statusOf(found);
}

std::ptrdiff_t InputFile::read(char* bytes, std::size_t count) {
  for (;;) {
    const ssize_t got = ::read(descriptor_, bytes, count);
    if (got >= 0 || errno != EINTR) return got;
  }
}

}  // namespace boxprobe
