// Whole or not at all: every file the program writes goes through here.
#pragma once

#include <functional>
#include <string>

namespace boxprobe {

/// Where writing to `path` ends: through symbolic links, which stay links, also if nothing is there yet.
std::string writtenPath(const std::string& path);

/// Calls `write` with the name of a temporary file in the folder of `path`, then flushes that file to disk and renames
/// it to `path`. If `write` throws or the flush or rename fails the temporary file is removed and `path` is untouched;
/// failures of the file system are WorkError naming `path` and the system's reason. A process that is killed meanwhile
/// leaves the old file and its temporary one, which removeTemporaryFiles() or the next write to `path` removes.
void writeAtomically(const std::string& path, const std::function<void(const std::string& temporary)>& write);

/// The common case: bytes that are in memory, text or not.
void writeTextAtomically(const std::string& path, const std::string& text);

}  // namespace boxprobe
