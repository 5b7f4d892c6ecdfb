// Where a surface point's view goes through glass, as places to draw lines between: into the object, what is mirrored
// within, out of it. The mathematics is that of the picture (shaders/shared/refraction.glsl). Called by the ray
// builder; knows no pipeline.
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
  std::vector<glm::dvec3> within;  ///< world, from the surface point to where it leaves: two places at least, or none
  SurfaceRay leaving;              ///< a ray that faces along the way it goes on, as rough as what it is looked up with
};

/// Nothing where all is reflected. `back`: the inside of the surface is seen.
std::optional<GlassRayPath> glassPath(const GlassSurface& glass, const SurfaceRay& ray, const RayView& view, bool back);

}  // namespace boxprobe
