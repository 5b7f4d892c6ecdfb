// See input_file.h.
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cstdint>

#include "filters/platform/input_file.h"
#include "filters/platform/windows_text.h"

namespace boxprobe {

namespace {

std::optional<FileStatus> statusOf(HANDLE handle) {
  FileStatus status;
  if (GetFileType(handle) != FILE_TYPE_DISK) {
    status.kind = FileStatus::Kind::Other;
    return status;
  }
  BY_HANDLE_FILE_INFORMATION found{};
  if (GetFileInformationByHandle(handle, &found) == 0) {
    setErrnoFromWindows();
    return {};
  }
  const bool folder = (found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  status.kind = folder ? FileStatus::Kind::Folder : FileStatus::Kind::File;
  status.size = std::uint64_t{found.nFileSizeHigh} << 32u | found.nFileSizeLow;
  status.identity = {found.dwVolumeSerialNumber, std::uint64_t{found.nFileIndexHigh} << 32u | found.nFileIndexLow};
  return status;
}

}  // namespace

std::optional<FileStatus> fileStatus(const std::string& path) {
  constexpr DWORD kAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  // Backup semantics: folders, too.
  const HANDLE handle = CreateFileW(wide(path).c_str(), FILE_READ_ATTRIBUTES, kAll, nullptr, OPEN_EXISTING,
                                    FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    setErrnoFromWindows();
    return {};
  }
  const auto status = statusOf(handle);
  CloseHandle(handle);
  return status;
}

InputFile::InputFile(const std::string& path) : descriptor_(openShared(path, GENERIC_READ, OPEN_EXISTING, _O_RDONLY)) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) _close(descriptor_);
}

std::optional<FileStatus> InputFile::status() const {
  return statusOf(reinterpret_cast<HANDLE>(_get_osfhandle(descriptor_)));
}

std::ptrdiff_t InputFile::read(char* bytes, std::size_t count) {
  constexpr std::size_t kMost = 1u << 30u;  // the C library counts in int
  return _read(descriptor_, bytes, static_cast<unsigned>(std::min(count, kMost)));
}

}  // namespace boxprobe
