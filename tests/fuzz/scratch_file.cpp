#include "tests/fuzz/scratch_file.h"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

#include "filters/core/base/one_line.h"
#include "tests/fuzz/parse_target.h"

namespace boxprobe::fuzz {

namespace fs = std::filesystem;

ScratchFile::ScratchFile() {
  std::error_code ignored;
  const fs::path memory = "/dev/shm";
  const fs::path parent = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
  std::string name = (parent / "boxprobe-fuzz-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
  folder_ = name;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string ScratchFile::write(const std::string& name, const std::string& bytes) const {
  std::ofstream file(path(name), std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw std::runtime_error(path(name) + ": cannot be written");
  return path(name);
}

void checkRefusal(const std::string& message) {
  constexpr std::size_t kLongest = 4096;  // file names and channel lists come from the input
  promise(!message.empty(), "a refusal says nothing");
  promise(message.find('\n') == std::string::npos, "a refusal has more than one line");
  promise(message.size() <= kLongest, "a refusal is longer than anyone reads");
}

}  // namespace boxprobe::fuzz
