// A captured and prefiltered probe on the CPU, as bake files, previews and explanations use it.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/light_table.h"
#include "filters/math/cube/relief.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

struct BakedMaps {
  /// Prefiltered chain; level 0 is the capture itself. Linear radiance premultiplied by coverage, alpha = coverage.
  CubeMap radiance;
  /// One level; the red channel holds the distance in scene units from the capture origin to the nearest surface, 0
  /// where there was none. Empty for maps without distances (the sky, an imported picture).
  CubeMap distance;
  ShCoefficients irradiance{};
  LazyRelief relief;           ///< of `distance`, for projections that follow rays
  LazyLightTable light;        ///< of `radiance`, for techniques that aim rays at what is bright
  glm::dvec3 capturedAt{0.0};  ///< capture origin, world
  /// Rotation of the box when it was captured, along whose axes the maps lie; 0: the world's. Irradiance is always
  /// along the world's.
  glm::dvec3 capturedRotation{0.0};
};

}  // namespace boxprobe
