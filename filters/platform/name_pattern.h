// Names chosen by a pattern, as shells do.
#pragma once

#include <string>

namespace boxprobe {

/// Does the whole name match? * is any text, ? any letter, [a-z] and [!a-z] one of or none of these, \ the next
/// letter itself.
bool matchesPattern(const std::string& pattern, const std::string& name);

}  // namespace boxprobe
