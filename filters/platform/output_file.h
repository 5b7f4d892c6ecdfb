// Files to be written: created where nothing was, flushed, put in another's place, removed. Where something fails,
// errno says why, on every system.
#pragma once

#include <cstddef>
#include <string>

namespace boxprobe {

enum class Access { UserAlone, AsUsual };  ///< AsUsual: what the user's settings (umask) give to new files

/// A new empty file, open for writing until the end of its life; not open if something stands there.
class NewFile {
 public:
  NewFile(const std::string& path, Access access);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool isOpen() const { return descriptor_ >= 0; }
  /// False if not all could be written.
  bool write(const char* bytes, std::size_t count);

 private:
  int descriptor_;
};

/// A name kept at a path where nothing was, in one step: a reader finds all of it or nothing. As the target of a
/// symbolic link where that can be, else in a file.
bool storeName(const std::string& path, const std::string& name);

/// What storeName() has kept there; empty if nothing is.
std::string storedName(const std::string& path);

/// Of a file that is replaced: its permissions, if it is there.
void copyPermissions(const std::string& from, const std::string& to);

enum class Flushed { Done, NotOpened, Failed };
/// A file's bytes on the disk. What has nothing to flush is Done.
Flushed flushFile(const std::string& path);
/// The names in a folder on the disk.
Flushed flushFolder(const std::string& path);

/// Renames `from` to `to`, in the place of a file that is there, in one step.
bool replaceFile(const std::string& from, const std::string& to);

/// Removes a file; on POSIX, may be called in a signal handler.
bool removeFile(const char* path) noexcept;
/// Removes a folder that is empty; on POSIX, may be called in a signal handler.
bool removeEmptyFolder(const char* path) noexcept;

}  // namespace boxprobe
