// Files that must not outlive the process: their names are kept where a signal handler reaches them. Used by everything
// that writes to a temporary name first. Knows nothing of what is in them.
#pragma once

#include <string>

namespace boxprobe {

/// Owns the name of a file, or of a folder that is empty by then, which is removed at the end or by
/// removeTemporaryFiles(). Its user creates and closes it.
class TemporaryName {
 public:
  explicit TemporaryName(std::string name);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const std::string& name() const { return name_; }
  /// It was renamed, or is somebody else's: not to be removed.
  void release();

 private:
  std::string name_;
  int slot_ = -1;
};

/// A new empty file in `folder`, its name starting with `start`. Throws WorkError naming the folder and the reason.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& folder, const std::string& start);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_.name(); }
  /// Throws WorkError if not all of it can be written.
  void write(const std::string& text);

 private:
  std::string folder_;
  TemporaryName name_;
  int descriptor_ = -1;
};

/// Of all that live now. For signal handlers that end the process: calls nothing but unlink() and rmdir().
void removeTemporaryFiles() noexcept;

}  // namespace boxprobe
