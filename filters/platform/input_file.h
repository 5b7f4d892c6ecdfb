// Files to be read: what stands at a path, and its bytes. Where something fails, errno says why, on every system.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace boxprobe {

/// The same for every path that leads to one file.
struct FileIdentity {
  std::uint64_t device = 0, file = 0;
  bool operator==(const FileIdentity& other) const { return device == other.device && file == other.file; }
};

struct FileStatus {
  enum class Kind { File, Folder, Other };  ///< Other: a pipe, a device, a socket
  Kind kind = Kind::File;
  std::uint64_t size = 0;  ///< bytes
  FileIdentity identity;
};

/// Of what the path leads to, by links too. Empty if there is nothing that can be asked.
std::optional<FileStatus> fileStatus(const std::string& path);

/// Open for reading until the end of its life; does not wait for the other end of a pipe.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  bool isOpen() const { return descriptor_ >= 0; }
  std::optional<FileStatus> status() const;
  /// How many bytes were read, as many as `count` or fewer: 0 at the end, negative on failure.
  std::ptrdiff_t read(char* bytes, std::size_t count);

 private:
  int descriptor_;
};

}  // namespace boxprobe
