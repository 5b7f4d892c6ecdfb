// Lights for a model whose file has none.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/fit/standing_points.h"

namespace boxprobe {

enum class FitLight {
  File,      ///< the lights of the model files
  Studio,    ///< a studio environment alone: key, rim, fill
  Ceiling,   ///< soft lamps under the ceiling
  Openings,  ///< skylight through the openings of a room
  Daylight,  ///< gradient sky and a sun
};

/// "file", "studio", "ceiling", "openings", "daylight".
const char* fitLightId(FitLight light);
const std::vector<FitLight>& allFitLights();

/// One lamp per square part of the room, at most four, at three quarters of its height.
std::vector<Light> ceilingLights(const Probe& probe, const StandingPoint& stand);

/// For each side of the probe's box through which its origin sees the sky, a spot light behind the middle of the
/// opening that shines inwards. Its intensity is the opening's area times the sky's radiance at the horizon. Empty for
/// a closed room, where less than 0.8 % of the rays of each side leave.
std::vector<Light> openingLights(const TriangleRays& rays, const Probe& probe);

/// A sun, 50 degrees high.
std::vector<Light> sunLight();

}  // namespace boxprobe
