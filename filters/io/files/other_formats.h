// Formats of models that are not read here, and what converts them.
#pragma once

#include <string>

namespace boxprobe {

/// One sentence without a full stop for a file of that extension (".fbx", lower case), for behind its path and ": ";
/// empty if nobody here knows the format.
std::string conversionAdvice(const std::string& extension);

}  // namespace boxprobe
