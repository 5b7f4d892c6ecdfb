// Classifies a model by rays from points within its bounds: an object to look at, an interior to stand in, or a place
// open to the sky.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

enum class ModelKind {
  Object,    ///< seen from outside: from inside, rays meet back faces or leave
  Interior,  ///< free space is closed: nearly every ray from there meets a front face
  Open,      ///< free space with a floor or walls, and sky: a courtyard, an atrium, a ground with objects
};

/// "object", "interior" or "open".
const char* modelKindId(ModelKind kind);

/// The hits of the rays from one point, as shares that sum to 1.
struct SurveyedPoint {
  glm::dvec3 positionWorld{0.0};
  double front = 0.0, back = 0.0, sky = 0.0;
  double frontBelow = 0.0;                   ///< share of front faces among steep downward rays
  double frontAround = 0.0;                  ///< share of front faces among rays up to 30 degrees above the horizon
  double clearance = 0.0;                    ///< distance of the nearest surface
  bool solid() const { return back > 0.3; }  ///< inside something, or behind it
  bool enclosed() const { return !solid() && sky <= 0.12 && back <= 0.2; }
  bool walled() const { return !solid() && frontBelow >= 0.75 && frontAround >= 0.5; }
  bool floored() const { return !solid() && frontBelow >= 0.85; }
};

struct ModelSurvey {
  ModelKind kind = ModelKind::Object;
  std::vector<SurveyedPoint> points;                                ///< distributed over the core of the model
  double solid = 0.0, enclosed = 0.0, walled = 0.0, floored = 0.0;  ///< shares of the points
  double sky = 0.0;                                                 ///< share of the rays of all points that leave
  double backOutside = 0.0;  ///< share of back faces seen from outside: high for the inner shell of a room
  double largest = 0.0;      ///< longest side of the core, scene units
  Phrase reason;             ///< one sentence
};

/// `points` are a deterministic jittered grid.
ModelSurvey surveyModel(const TriangleRays& rays);

}  // namespace boxprobe
