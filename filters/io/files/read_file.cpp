// See the header.
#include "filters/io/files/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

struct DeclaredOutput {
  dev_t device;
  ino_t inode;
  std::string called;  ///< "-o out.png"
};

std::vector<DeclaredOutput>& declaredOutputs() {
  static std::vector<DeclaredOutput> outputs;
  return outputs;
}

void requireInput(const std::string& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) throw InputError(path + ": is a folder; name a file");
  if (!S_ISREG(status.st_mode)) throw InputError(path + ": is not a file but a pipe or device; name a file");
  for (const DeclaredOutput& output : declaredOutputs()) {
    if (output.device != status.st_dev || output.inode != status.st_ino) continue;
    throw InputError(output.called + ": this is the input " + path + "; write to another file");
  }
}

[[noreturn]] void cannotOpen(const std::string& path, int reason) {
  if (reason == ENOENT || reason == ENOTDIR) throw InputError(path + ": does not exist; check the path");
  throw InputError(path + ": cannot be opened: " + std::strerror(reason));
}

/// Closes at the end of its life.
struct OpenFile {
  explicit OpenFile(int opened) : descriptor(opened) {}
  ~OpenFile() { ::close(descriptor); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor;
};

}  // namespace

std::string readWholeFile(const std::string& path, std::uintmax_t limit) {
  requireInputFile(path);  // before it is opened: opening alone triggers some devices
  const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (opened < 0) cannotOpen(path, errno);
  const OpenFile file(opened);
  struct stat status = {};
  if (::fstat(file.descriptor, &status) != 0) cannotOpen(path, errno);
  requireInput(path, status);
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > limit) {
    throw InputError(path + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(limit) + " are read");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  for (std::size_t got = 0; got < bytes.size();) {
    const ssize_t count = ::read(file.descriptor, bytes.data() + got, bytes.size() - got);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw InputError(path + ": could not be read to its end; it changed, or the disk failed");
    got += static_cast<std::size_t>(count);
  }
  return bytes;
}

std::uintmax_t requireInputFile(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) cannotOpen(path, errno);
  requireInput(path, status);
  return static_cast<std::uintmax_t>(status.st_size);
}

void declareOutput(const std::string& option, const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return;
  declaredOutputs().push_back({status.st_dev, status.st_ino, option + " " + path});
}

}  // namespace boxprobe
