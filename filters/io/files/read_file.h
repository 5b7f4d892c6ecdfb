// Reads a whole file, and checks every file before it is opened, with one-line errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace boxprobe {

/// Throws InputError with the file if it is missing, a folder, a pipe or device, not readable, larger than `limit`
/// bytes, or a declared output.
std::string readWholeFile(const std::string& path, std::uintmax_t limit = std::uintmax_t(4) << 30);

/// The same checks without the limit, for libraries that open files themselves: a pipe would block them forever.
/// Returns the size in bytes.
std::uintmax_t requireInputFile(const std::string& path);

/// What tells that a file was written again: its time and its size in bytes. A missing file has the earliest time.
struct FileStamp {
  std::filesystem::file_time_type time = std::filesystem::file_time_type::min();
  std::uintmax_t size = 0;
  bool operator==(const FileStamp& other) const { return time == other.time && size == other.size; }
};
FileStamp stampOf(const std::string& path);

/// Collects, while it lives, which files are asked for in any thread by the functions above or by noteAsked(): those
/// that are not there as well, since they may come. One at a time.
class FilesAsked {
 public:
  FilesAsked();
  ~FilesAsked();
  FilesAsked(const FilesAsked&) = delete;
  FilesAsked& operator=(const FilesAsked&) = delete;
  /// Each file as it was before it was first read, so that one that is written meanwhile differs.
  std::map<std::string, FileStamp> stamps() const;

 private:
  std::map<std::string, FileStamp> stamps_;
};
/// For files that are looked for before they are read.
void noteAsked(const std::string& path);

/// From now on reading the file that `path` leads to, by device and inode, is an error: `option` ("-o") would overwrite
/// an input. Call it before anything is read. Files that do not exist yet cannot be inputs.
void declareOutput(const std::string& option, const std::string& path);

}  // namespace boxprobe
