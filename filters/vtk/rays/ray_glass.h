// The path of a surface point's view through glass, as points for lines: into the object, internal reflections, out of
// it. Uses the picture's mathematics (shaders/shared/refraction.glsl).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/vtk/draw/glass_surface.h"
#include "filters/vtk/rays/ray_calculation.h"

namespace boxprobe {

struct RayGlass {
  std::string object;  ///< node name
  GlassSurface surface;
};

struct GlassRayPath {
  std::vector<glm::dvec3> within;  ///< world, from the surface point to the exit: at least two points, or none
  SurfaceRay leaving;              ///< a ray in the direction after the exit, with the roughness for sampling
};

/// Nothing for total reflection. `back`: the inner side of the surface is seen.
std::optional<GlassRayPath> glassPath(const GlassSurface& glass, const SurfaceRay& ray, const RayView& view, bool back);

}  // namespace boxprobe
