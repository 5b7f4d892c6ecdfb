// Is a model an object to look at, an interior to stand in, or a place open to the sky? Found by rays from points
// within its bounds. Called where a model is opened without a scene, and by `info`.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

enum class ModelKind {
  Object,    ///< looked at from outside: from within, the rays meet back sides or leave
  Interior,  ///< closed about its free space: nearly every ray from there meets a front
  Open,      ///< a floor or walls about free space, and sky: a courtyard, an atrium, a ground with things on it
};

/// "object", "interior" or "open".
const char* modelKindId(ModelKind kind);

/// What the rays from one point met, shares that add up to 1.
struct SurveyedPoint {
  glm::dvec3 positionWorld{0.0};
  double front = 0.0, back = 0.0, sky = 0.0;
  double frontBelow = 0.0;                   ///< fronts among the rays that go down steeply
  double frontAround = 0.0;                  ///< fronts among the rays up to 30 degrees above the horizon
  double clearance = 0.0;                    ///< distance of the nearest surface
  bool solid() const { return back > 0.3; }  ///< within something, or behind it
  bool enclosed() const { return !solid() && sky <= 0.12 && back <= 0.2; }
  bool walled() const { return !solid() && frontBelow >= 0.75 && frontAround >= 0.5; }
  bool floored() const { return !solid() && frontBelow >= 0.85; }
};

struct ModelSurvey {
  ModelKind kind = ModelKind::Object;
  std::vector<SurveyedPoint> points;                                ///< spread over the core of the model
  double solid = 0.0, enclosed = 0.0, walled = 0.0, floored = 0.0;  ///< shares of the points
  double sky = 0.0;                                                 ///< rays that leave, of all points
  double backOutside = 0.0;  ///< backs among what rays from outside meet: a lone inner shell shows nothing else
  double largest = 0.0;      ///< longest side of the core, scene units
  std::string reason;        ///< one sentence
};

/// `points` are spread over a jittered grid, the same on every run.
ModelSurvey surveyModel(const TriangleRays& rays);

}  // namespace boxprobe
