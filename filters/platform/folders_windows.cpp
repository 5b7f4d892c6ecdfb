// See folders.h.
#include <windows.h>

#include <cerrno>
#include <random>

#include "filters/platform/folders.h"
#include "filters/platform/windows_text.h"

namespace boxprobe {

namespace {

bool isPlainFolder(const std::string& folder) {
  const DWORD attributes = GetFileAttributesW(wide(folder).c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) {
    setErrnoFromWindows();
    return false;
  }
  errno = ENOTDIR;
  return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) == 0;
}

}  // namespace

// Who may enter follows from the folder it is in: folders of users are their own.
std::optional<std::string> makeFolder(const std::string& start) {
  static thread_local std::mt19937_64 random{std::random_device{}()};
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789";  // names do not differ by case
  constexpr int kTries = 100, kCount = 6;
  for (int i = 0; i < kTries; ++i) {
    std::string made = start;
    for (int k = 0; k < kCount; ++k) made += kLetters[random() % (sizeof kLetters - 1)];
    if (CreateDirectoryW(wide(made).c_str(), nullptr) != 0) return made;
    setErrnoFromWindows();
    if (errno != EEXIST) break;
  }
  return {};
}

// Permissions of Windows are not the read-only mark of folders: what asks whether a file can be created creates one.
bool canWriteInto(const std::string& folder) {
  const auto made = makeFolder(folder + "/.boxprobe-");
  if (made) RemoveDirectoryW(wide(*made).c_str());
  return made.has_value();
}

// What is in a user's profile belongs to the user.
bool isUsersOwn(const std::string& folder) {
  return isPlainFolder(folder);
}

FolderLock::FolderLock(const std::string& folder) : folder_(folder) {}

FolderLock::~FolderLock() {
  if (handle_ != nullptr) CloseHandle(handle_);
}

bool FolderLock::isOpen() const {
  return isPlainFolder(folder_);
}

// A handle that shares with nobody: there can be one of its kind. Files in the folder are not concerned.
bool FolderLock::lock() {
  const HANDLE handle = CreateFileW(wide(folder_).c_str(), GENERIC_READ | DELETE, 0, nullptr, OPEN_EXISTING,
                                    FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    setErrnoFromWindows();
    return false;
  }
  handle_ = handle;
  return true;
}

void FolderLock::remove() {
  if (handle_ == nullptr) return;
  FILE_DISPOSITION_INFO gone{};
  gone.DeleteFile = TRUE;  // once the handle is closed; fails unless it is empty
  SetFileInformationByHandle(handle_, FileDispositionInfo, &gone, sizeof gone);
}

}  // namespace boxprobe
