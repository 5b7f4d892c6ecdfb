// A whole file into memory, and what is asked of every file before it is opened, with one-line errors. Called by every
// reader in this folder.
#pragma once

#include <cstdint>
#include <string>

namespace boxprobe {

/// Throws InputError naming the file: not there, a folder, a pipe or device, not readable, above `limit` bytes, or a
/// declared output.
std::string readWholeFile(const std::string& path, std::uintmax_t limit = std::uintmax_t(4) << 30);

/// The same checks but the limit, for libraries that open files themselves: a pipe would hold them for ever. Returns
/// the size in bytes.
std::uintmax_t requireInputFile(const std::string& path);

/// From now on no file that is read may be the one that `path` leads to, by device and inode: `option` ("-o") would
/// overwrite it. To be said before anything is read. Files that are not there yet are no inputs.
void declareOutput(const std::string& option, const std::string& path);

}  // namespace boxprobe
