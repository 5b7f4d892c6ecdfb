// See name_pattern.h.
#include <fnmatch.h>

#include "filters/platform/name_pattern.h"

namespace boxprobe {

bool matchesPattern(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace boxprobe
