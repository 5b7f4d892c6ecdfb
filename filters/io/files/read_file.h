// Reads a whole file, and checks every file before it is opened, with one-line errors.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace boxprobe {

/// Throws InputError with the file if it is missing, a folder, a pipe or device, not readable, larger than `limit`
/// bytes, or a declared output.
std::string readWholeFile(const std::string& path, std::uintmax_t limit = std::uintmax_t(4) << 30);

/// The same checks without the limit, for libraries that open files themselves: a pipe would block them forever.
/// Returns the size in bytes.
std::uintmax_t requireInputFile(const std::string& path);

/// Collects, while it lives, which files are asked for in any thread by the functions above or by noteAsked(): those
/// that are not there as well, since they may come. One at a time.
class FilesAsked {
 public:
  FilesAsked();
  ~FilesAsked();
  FilesAsked(const FilesAsked&) = delete;
  FilesAsked& operator=(const FilesAsked&) = delete;
  std::vector<std::string> names() const;  ///< sorted, each once

 private:
  std::set<std::string> names_;
};
/// For files that are looked for before they are read.
void noteAsked(const std::string& path);

/// From now on reading the file that `path` leads to, by device and inode, is an error: `option` ("-o") would overwrite
/// an input. Call it before anything is read. Files that do not exist yet cannot be inputs.
void declareOutput(const std::string& option, const std::string& path);

}  // namespace boxprobe
