// Folders: new ones, whose they are, and which processes work in them. Where something fails, errno says why, on every
// system.
#pragma once

#include <optional>
#include <string>

namespace boxprobe {

/// A new folder that only this user may enter; its name is `start` and six letters.
std::optional<std::string> makeFolder(const std::string& start);

/// May files be created in it?
bool canWriteInto(const std::string& folder);

/// Is it a folder, no link to one, that belongs to this user and that not everybody can write into?
bool isUsersOwn(const std::string& folder);

/// A folder, locked from lock() to the end of its life; a process that is killed lets go, too.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False if it is no folder, or a link to one.
  bool isOpen() const;
  /// False if another process has locked it, or if it cannot be locked.
  bool lock();
  /// Removes the folder if it is empty. Locked until then.
  void remove();

 private:
  std::string folder_;
  int descriptor_ = -1;     ///< of POSIX
  void* handle_ = nullptr;  ///< of Windows
};

}  // namespace boxprobe
