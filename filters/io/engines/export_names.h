// Names of exported files: engines, web servers and file systems allow fewer characters than scene files do.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// One stem per probe: letters, digits, '-' and '_' stay, everything else becomes '_'. Throws InputError if two are
/// equal on a file system that ignores case.
std::vector<std::string> exportStems(const std::vector<std::string>& probeNames);

}  // namespace boxprobe
