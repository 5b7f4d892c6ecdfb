// Refuses an output that could not be written before the work is done, not after.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// Throws InputError naming `option` (as on the command line) and `path` unless a file can be created there: the folder
/// exists and takes a new file, and `path` is no folder. To be called before anything is read: from then on reading the
/// file that `path` leads to is an InputError, too.
void requireWritable(const std::string& option, const std::string& path);

/// Throws InputError if the file system has no file of so long a name or path.
void requireShortName(const std::string& option, const std::string& path);

/// Makes the folder that `option` names where it is missing, before hours of work and not after them. Throws InputError
/// if it is a file, WorkError if it cannot be made or written into.
void requireOutputFolder(const std::string& option, const std::string& folder);

/// The extension of `path` in lower case; throws InputError naming the ones there are if it is none of `extensions`.
std::string requireExtension(const std::string& option, const std::string& path,
                             const std::vector<std::string>& extensions);

}  // namespace boxprobe
