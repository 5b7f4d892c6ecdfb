// The keys of a cube map's faces, in the order +X, -X, +Y, -Y, +Z, -Z: equal keys, equal texels. An empty text is a
// face nobody may use again.
#pragma once

#include <array>
#include <string>

namespace boxprobe {

using FaceKeys = std::array<std::string, 6>;

}  // namespace boxprobe
