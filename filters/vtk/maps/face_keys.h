// The keys of a cubemap's faces, in the order +X, -X, +Y, -Y, +Z, -Z: equal keys mean equal texels. An empty key marks
// a face that must not be reused.
#pragma once

#include <array>
#include <string>

namespace boxprobe {

using FaceKeys = std::array<std::string, 6>;

}  // namespace boxprobe
