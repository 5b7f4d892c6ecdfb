// Where a person could stand in an interior or a court: free points at eye height above a floor.
#pragma once

#include <vector>

#include "filters/fit/model_kind.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

struct StandingPoint {
  glm::dvec3 eyeWorld{0.0};
  double floor = 0.0;      ///< world y below the eye
  double height = 0.0;     ///< from the floor to the ceiling, or to the top of the model
  double clearance = 0.0;  ///< distance of the nearest surface except the floor
};

/// From the survey's enclosed points (in an open place, those between walls), the best first: free space around it,
/// near the middle of all. Empty if nobody can stand there.
std::vector<StandingPoint> standingPoints(const TriangleRays& rays, const ModelSurvey& survey);

}  // namespace boxprobe
