// See output_check.h.
#include "app/session/output_check.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"
#include "filters/io/files/temporary_file.h"
#include "filters/platform/folders.h"
#include "filters/platform/input_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

/// Two options of a command that name one file: what is written first would be lost. A window may write it again.
void requireAnother(const std::string& option, const std::string& path) {
  if (option.empty() || option.front() != '-') return;
  static std::map<std::string, std::string> options;
  std::error_code ignored;
  // Absolute first: of a path whose beginning does not exist nothing is resolved.
  const std::string target = fs::weakly_canonical(fs::absolute(writtenPath(path), ignored), ignored).string();
  const auto [known, isNew] = options.emplace(target, option);
  if (isNew || known->second == option) return;
  throw InputError(option + " " + path + ": " + known->second + " writes to this file; name another");
}

}  // namespace

void requireShortName(const std::string& option, const std::string& path) {
  // A file is written in a folder of its own first: atomic_file.h.
  const std::string place = option + " " + path + ": ";
  const fs::path target = writtenPath(path);
  for (const fs::path& each : {target, target.parent_path() / unfinishedFolderName() / target.filename()}) {
    std::error_code reason;
    if (fs::exists(each, reason) || reason != std::errc::filename_too_long) continue;
    throw InputError(place + reason.message() + "; choose a shorter one");
  }
}

void requireWritable(const std::string& option, const std::string& path) {
  const std::string place = option + " " + path + ": ";
  std::error_code ignored;
  fs::path folder = fs::path(writtenPath(path)).parent_path();
  if (folder.empty()) folder = ".";
  if (const auto there = fileStatus(path); there && there->kind == FileStatus::Kind::Other) {
    throw InputError(place + "this is a pipe or device, not a file; name a file");
  }
  if (!fs::exists(folder, ignored))
    throw InputError(place + "the folder " + folder.string() + " does not exist; create it first");
  if (!fs::is_directory(folder, ignored)) throw InputError(place + folder.string() + " is a file, not a folder");
  if (fs::is_directory(path, ignored)) throw InputError(place + "this is a folder; name a file in it");
  requireShortName(option, path);
  // Permissions, read-only mounts and root's privileges are the kernel's to weigh: a file is created and removed.
  try {
    const TemporaryFile probe(folder.string(), ".boxprobe-");
  } catch (const WorkError& error) {
    throw InputError(place + error.what());
  }
  requireAnother(option, path);
  declareOutput(option, path);
}

void requireOutputFolder(const std::string& option, const std::string& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError(folder + ": this is a file; " + option + " names a folder");
  }
  fs::create_directories(folder, error);
  if (error == std::errc::filename_too_long) {
    throw InputError(option + " " + folder + ": " + error.message() + "; choose a shorter one");
  }
  if (error) throw WorkError(folder + ": cannot create this folder: " + error.message());
  if (!canWriteInto(folder)) throw WorkError(folder + ": cannot write into this folder");
}

std::string requireExtension(const std::string& option, const std::string& path,
                             const std::vector<std::string>& extensions) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return extension;
  std::string list;
  for (const std::string& known : extensions) list += (list.empty() ? "" : " or ") + known;
  throw InputError(option + " " + path + ": the file name must end in " + list);
}

}  // namespace boxprobe
