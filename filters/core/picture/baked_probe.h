// A captured and prefiltered probe on the CPU: what the bake files hold, what previews show and explanations look up.
// Plain values; knows neither VTK nor files.
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
  /// One level, in the red channel: from the capture origin to what was seen, scene units; 0 where nothing was. Empty
  /// for a map without distances (the sky, an imported picture).
  CubeMap distance;
  ShCoefficients irradiance{};
  LazyRelief relief;           ///< of distance, for projections that follow rays
  LazyLightTable light;        ///< of radiance, for techniques that aim rays at what is bright
  glm::dvec3 capturedAt{0.0};  ///< capture origin, world
  /// Of the box when it was captured, whose axes the maps lie along; 0: the world's. Irradiance is the world's anyway.
  glm::dvec3 capturedRotation{0.0};
};

}  // namespace boxprobe
