// What every clear coat is. Read by the renderer and the ray tracer.
#pragma once

namespace boxprobe {

/// Index of refraction of a clear coat (KHR_materials_clearcoat); VTK's own, unless it is told, is 2.
inline constexpr float kCoatIor = 1.5f;

}  // namespace boxprobe
