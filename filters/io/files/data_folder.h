// The program's own data: scenes, lessons, environments. Located relative to the program, so that an installation can
// be moved: PREFIX/bin/boxprobe has PREFIX/share/boxprobe, and the build folder has the same layout.
#pragma once

#include <string>

namespace boxprobe {

/// `below`: path within the data folder. Uses the nearest folder above the running program that has share/boxprobe; if
/// there is none, the path that an installation would have. Links are resolved.
std::string dataFile(const std::string& below);

}  // namespace boxprobe
