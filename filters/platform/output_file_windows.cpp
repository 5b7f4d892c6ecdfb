// See output_file.h.
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>

#include "filters/platform/input_file.h"
#include "filters/platform/output_file.h"
#include "filters/platform/windows_text.h"

namespace boxprobe {

namespace {

bool done(BOOL result) {
  if (result == 0) setErrnoFromWindows();
  return result != 0;
}

}  // namespace

// Who may read a file follows from its folder, whatever `access` says: folders of users are their own.
NewFile::NewFile(const std::string& path, Access)
    : descriptor_(openShared(path, GENERIC_WRITE, CREATE_NEW, _O_WRONLY)) {}

NewFile::~NewFile() {
  if (descriptor_ >= 0) _close(descriptor_);
}

bool NewFile::write(const char* bytes, std::size_t count) {
  constexpr std::size_t kMost = 1u << 30u;  // the C library counts in int
  while (count > 0) {
    const int written = _write(descriptor_, bytes, static_cast<unsigned>(std::min(count, kMost)));
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

// Symbolic links need a privilege there.
bool storeName(const std::string& path, const std::string& name) {
  NewFile file(path, Access::UserAlone);
  return file.isOpen() && file.write(name.data(), name.size());
}

std::string storedName(const std::string& path) {
  InputFile file(path);
  char text[1024];
  const std::ptrdiff_t size = file.isOpen() ? file.read(text, sizeof text) : 0;
  return {text, static_cast<std::size_t>(size > 0 ? size : 0)};
}

void copyPermissions(const std::string&, const std::string&) {}  // they follow from the folder

Flushed flushFile(const std::string& path) {
  constexpr DWORD kAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE handle = CreateFileW(wide(path).c_str(), GENERIC_WRITE, kAll, nullptr, OPEN_EXISTING, 0, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    setErrnoFromWindows();
    return Flushed::NotOpened;
  }
  const bool flushed = done(FlushFileBuffers(handle));
  CloseHandle(handle);
  return flushed ? Flushed::Done : Flushed::Failed;
}

Flushed flushFolder(const std::string&) {
  return Flushed::Done;  // by replaceFile()
}

bool replaceFile(const std::string& from, const std::string& to) {
  return done(MoveFileExW(wide(from).c_str(), wide(to).c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH));
}

bool removeFile(const char* path) noexcept {
  return done(DeleteFileW(wide(path).c_str()));
}

bool removeEmptyFolder(const char* path) noexcept {
  return done(RemoveDirectoryW(wide(path).c_str()));
}

}  // namespace boxprobe
