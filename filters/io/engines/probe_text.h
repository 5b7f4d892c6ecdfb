// A probe as one line of the scene file's JSON, which exports carry beside an engine's own fields: what an engine has
// no field for comes back on import. Internal to this folder.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Defaults are left out; the picture of a custom probe keeps its path.
std::string probeLine(const Probe& probe);

/// Reads it back, validated. Throws InputError that begins with `name`.
Probe probeOfLine(const std::string& line, const std::string& name);

}  // namespace boxprobe
