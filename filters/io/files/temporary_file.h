// Files that must not outlive the process: their names are stored where a signal handler can reach them.
#pragma once

#include <string>

#include "filters/platform/output_file.h"

namespace boxprobe {

/// Owns the name of a file, or of a folder that will be empty, which the destructor or removeTemporaryFiles() removes.
/// The user creates and closes the file.
class TemporaryName {
 public:
  explicit TemporaryName(std::string name);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const std::string& name() const { return name_; }
  /// The file was renamed, or is not ours: do not remove it.
  void release();

 private:
  std::string name_;
  int slot_ = -1;
};

/// A new empty file in `folder` whose name starts with `start`. Throws WorkError with the folder and the reason.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& folder, const std::string& start);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_.name(); }
  /// Throws WorkError if it cannot be written completely.
  void write(const std::string& text);

 private:
  std::string folder_;
  TemporaryName name_;
  NewFile file_;
};

/// Removes all files registered now. For signal handlers that end the process: calls only removeFile() and
/// removeEmptyFolder().
void removeTemporaryFiles() noexcept;

}  // namespace boxprobe
