// See folders.h.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "filters/platform/folders.h"

namespace boxprobe {

std::optional<std::string> makeFolder(const std::string& start) {
  std::string made = start + "XXXXXX";
  if (::mkdtemp(made.data()) == nullptr) return {};
  return made;
}

bool canWriteInto(const std::string& folder) {
  return ::access(folder.c_str(), W_OK) == 0;
}

bool isUsersOwn(const std::string& folder) {
  struct stat found {};
  return ::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::getuid() &&
         (found.st_mode & S_IWOTH) == 0;
}

FolderLock::FolderLock(const std::string& folder)
    : folder_(folder), descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool FolderLock::isOpen() const {
  return descriptor_ >= 0;
}

bool FolderLock::lock() {
  return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
}

void FolderLock::remove() {
  ::rmdir(folder_.c_str());
}

}  // namespace boxprobe
