// Every file of the program is written through these functions: completely or not at all.
#pragma once

#include <functional>
#include <string>

namespace boxprobe {

/// The file that writing to `path` replaces: follows symbolic links, which stay links, also if nothing exists there
/// yet.
std::string writtenPath(const std::string& path);

/// A name as long as those of the folders that files are written in first.
std::string unfinishedFolderName();

/// Calls `write` with the path of a file of that name in a new folder beside `path`, which only this user may enter.
/// Then flushes that file to disk and renames it to `path`. If `write` throws or the flush or rename fails, the folder
/// is removed and `path` is untouched; file system errors are WorkError with `path` and the system's reason. A process
/// that is killed meanwhile leaves the old file and that folder, which removeTemporaryFiles() or the next write into
/// the same folder removes; a claim in it says which file is this program's. No other file is ever removed.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// The common case: writes bytes that are in memory.
void writeTextAtomically(const std::string& path, const std::string& text);

}  // namespace boxprobe
