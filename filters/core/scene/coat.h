// A property common to all clear coats.
#pragma once

namespace boxprobe {

/// Index of refraction of a clear coat (KHR_materials_clearcoat). VTK's default is 2.
inline constexpr float kCoatIor = 1.5f;

}  // namespace boxprobe
