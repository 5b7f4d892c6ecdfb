// Light for a model whose file has none. Called by fit_model.
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
  Openings,  ///< the sky's light through the openings of a room
  Daylight,  ///< gradient sky and a sun
};

/// "file", "studio", "ceiling", "openings", "daylight".
const char* fitLightId(FitLight light);
const std::vector<FitLight>& allFitLights();

/// One lamp for each square of the room, four at most, at three quarters of its height.
std::vector<Light> ceilingLights(const Probe& probe, const StandingPoint& stand);

/// For each side of the probe's box through which the sky is seen from its origin, a spot that stands behind the
/// opening's middle and shines inwards, as strong as the opening's area times the sky's radiance at the horizon. Empty:
/// the room is closed, which it is where less than 0.8 % of the rays of a side leave.
std::vector<Light> openingLights(const TriangleRays& rays, const Probe& probe);

/// A sun, 50 degrees high.
std::vector<Light> sunLight();

}  // namespace boxprobe
