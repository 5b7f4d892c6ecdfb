// See the header.
#include "filters/io/files/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "filters/core/base/errors.h"

namespace boxprobe {

std::string readWholeFile(const std::string& path, std::uintmax_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path + ": does not exist; check the path");
  if (!std::filesystem::is_regular_file(status)) throw InputError(path + ": is not a file; name a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > limit) {
    throw InputError(path + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(limit) + " are read");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened: " + std::strerror(errno));
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::uintmax_t>(file.gcount()) != bytes.size()) {
    throw InputError(path + ": could not be read to its end; it changed, or the disk failed");
  }
  return bytes;
}

}  // namespace boxprobe
