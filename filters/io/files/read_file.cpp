// See the header.
#include "filters/io/files/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/platform/input_file.h"

namespace boxprobe {

namespace {

struct DeclaredOutput {
  FileIdentity file;
  std::string path, called;  ///< called: "-o out.png"
};

std::vector<DeclaredOutput>& declaredOutputs() {
  static std::vector<DeclaredOutput> outputs;
  return outputs;
}

std::mutex askedMutex;
std::map<std::string, FileStamp>* asked = nullptr;  // while somebody collects

void requireInput(const std::string& path, const FileStatus& status) {
  if (status.kind == FileStatus::Kind::Folder) throw InputError(path + ": is a folder; name a file");
  if (status.kind != FileStatus::Kind::File) {
    throw InputError(path + ": is not a file but a pipe or device; name a file");
  }
  for (const DeclaredOutput& output : declaredOutputs()) {
    if (!(output.file == status.identity)) continue;
    // The number of a file that was replaced may be another file's since.
    if (const auto now = fileStatus(output.path); now && !(now->identity == output.file)) continue;
    throw InputError(output.called + ": this is the input " + path + "; write to another file");
  }
}

[[noreturn]] void cannotOpen(const std::string& path, int reason) {
  if (reason == ENOENT || reason == ENOTDIR) throw InputError(path + ": does not exist; check the path");
  throw InputError(path + ": cannot be opened: " + std::strerror(reason));
}

}  // namespace

std::string readWholeFile(const std::string& path, std::uintmax_t limit) {
  requireInputFile(path);  // before it is opened: opening alone triggers some devices
  InputFile file(path);
  if (!file.isOpen()) cannotOpen(path, errno);
  const auto status = file.status();
  if (!status) cannotOpen(path, errno);
  requireInput(path, *status);
  const std::uintmax_t size = status->size;
  if (size > limit) {
    throw InputError(path + ": has " + std::to_string(size) + " bytes; at most " + std::to_string(limit) + " are read");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  for (std::size_t got = 0; got < bytes.size();) {
    const std::ptrdiff_t count = file.read(bytes.data() + got, bytes.size() - got);
    if (count <= 0) throw InputError(path + ": could not be read to its end; it changed, or the disk failed");
    got += static_cast<std::size_t>(count);
  }
  return bytes;
}

FilesAsked::FilesAsked() {
  const std::lock_guard lock(askedMutex);
  asked = &stamps_;
}

FilesAsked::~FilesAsked() {
  const std::lock_guard lock(askedMutex);
  if (asked == &stamps_) asked = nullptr;
}

std::map<std::string, FileStamp> FilesAsked::stamps() const {
  const std::lock_guard lock(askedMutex);
  return stamps_;
}

FileStamp stampOf(const std::string& path) {
  std::error_code missing, ignored;
  const auto time = std::filesystem::last_write_time(path, missing);
  return missing ? FileStamp() : FileStamp{time, std::filesystem::file_size(path, ignored)};
}

void noteAsked(const std::string& path) {
  const std::lock_guard lock(askedMutex);
  if (asked != nullptr && asked->count(path) == 0) asked->emplace(path, stampOf(path));
}

std::uintmax_t requireInputFile(const std::string& path) {
  noteAsked(path);
  const auto status = fileStatus(path);
  if (!status) cannotOpen(path, errno);
  requireInput(path, *status);
  return status->size;
}

void declareOutput(const std::string& option, const std::string& path) {
  if (const auto status = fileStatus(path)) declaredOutputs().push_back({status->identity, path, option + " " + path});
}

}  // namespace boxprobe
