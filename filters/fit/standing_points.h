// Where a person could stand in an interior or a court: free points at the height of the eyes above a floor. Called by
// what fits probes, cameras and lights of interiors.
#pragma once

#include <vector>

#include "filters/fit/model_kind.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

struct StandingPoint {
  glm::dvec3 eyeWorld{0.0};
  double floor = 0.0;      ///< world y below the eye
  double height = 0.0;     ///< from the floor to the ceiling; to the top of the model where there is none
  double clearance = 0.0;  ///< distance of the nearest surface, the floor aside
};

/// From the survey's closed in points (of an open place: those within walls); the best placed first: free about it and
/// near the middle of all. Empty where nobody can stand.
std::vector<StandingPoint> standingPoints(const TriangleRays& rays, const ModelSurvey& survey);

}  // namespace boxprobe
