// One file of a process, written again for each input: the readers take paths.
#pragma once

#include <filesystem>
#include <string>

namespace boxprobe::fuzz {

class ScratchFile {
 public:
  /// A new folder, in memory where the system offers that, removed at the end.
  ScratchFile();
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Returns path(name).
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace boxprobe::fuzz
