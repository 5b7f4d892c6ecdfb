// Names of exported files. Engines, web servers and file systems take fewer characters than scene files do.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// One stem per probe: letters, digits, '-' and '_' as they are, everything else as '_'. Throws InputError if two are
/// the same on a file system that ignores case.
std::vector<std::string> exportStems(const std::vector<std::string>& probeNames);

}  // namespace boxprobe
