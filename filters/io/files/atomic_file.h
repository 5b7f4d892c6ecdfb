// Whole or not at all: every file the program writes goes through here.
#pragma once

#include <functional>
#include <string>

namespace boxprobe {

/// Where writing to `path` ends: through symbolic links, which stay links, also if nothing is there yet.
std::string writtenPath(const std::string& path);

/// Calls `write` with the name of a file of that name in a new folder beside `path`, which only this user may enter.
/// Then flushes that file to disk and renames it to `path`. If `write` throws or the flush or rename fails, the folder
/// goes and `path` is untouched; failures of the file system are WorkError naming `path` and the system's reason. A
/// process that is killed meanwhile leaves the old file and that folder, which removeTemporaryFiles() or the next write
/// into the same folder removes: its claim says which file is this program's. No other file is ever removed.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// The common case: bytes that are in memory, text or not.
void writeTextAtomically(const std::string& path, const std::string& text);

}  // namespace boxprobe
