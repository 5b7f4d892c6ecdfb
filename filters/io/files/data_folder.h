// Where the program's own data is: scenes, lessons, environments. Found by the program's place, so that an installation
// may lie anywhere: PREFIX/bin/boxprobe has PREFIX/share/boxprobe, and so has the build folder.
#pragma once

#include <string>

namespace boxprobe {

/// `below`: path within the data folder. Of the first folder above the running program that has a share/boxprobe;
/// where none has, what an installation beside the program would be called. Links are resolved.
std::string dataFile(const std::string& below);

}  // namespace boxprobe
