// See model_kind.h.
#include "filters/fit/model_kind.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>

#include "filters/math/sampling/van_der_corput.h"

namespace boxprobe {

namespace {

constexpr int kAcross = 7, kLayers = 5;  // points: 7 x 5 x 7
constexpr int kSurveyRays = 64;          // per point

SurveyedPoint surveyed(const TriangleRays& rays, const glm::dvec3& from, const std::vector<glm::dvec3>& directions) {
  SurveyedPoint point;
  point.positionWorld = from;
  point.clearance = std::numeric_limits<double>::infinity();
  double below = 0.0, around = 0.0, frontBelow = 0.0, frontAround = 0.0;
  for (const glm::dvec3& direction : directions) {
    const std::optional<SurfaceHit> hit = rays.first(from, direction);
    const bool front = hit && !hit->back;
    point.front += front ? 1.0 : 0.0;
    point.back += hit && hit->back ? 1.0 : 0.0;
    point.sky += hit ? 0.0 : 1.0;
    if (hit) point.clearance = std::min(point.clearance, hit->distance);
    if (direction.y < -0.6) {
      below += 1.0;
      frontBelow += front ? 1.0 : 0.0;
    } else if (direction.y > 0.0 && direction.y < 0.5) {
      around += 1.0;
      frontAround += front ? 1.0 : 0.0;
    }
  }
  const double all = static_cast<double>(directions.size());
  point.front /= all;
  point.back /= all;
  point.sky /= all;
  point.frontBelow = frontBelow / below;
  point.frontAround = frontAround / around;
  return point;
}

/// The share of back faces among the hits of rays from a sphere around the core towards points in it.
double backFromOutside(const TriangleRays& rays) {
  constexpr int kOutside = 512;
  const Box core = rays.core();
  const double radius = glm::length(rays.bounds().size());
  double hits = 0.0, backs = 0.0;
  int index = 0;
  for (const glm::dvec3& direction : fibonacciDirections(kOutside)) {
    ++index;
    const glm::dvec3 target =
        core.min + core.size() * glm::dvec3(vanDerCorput(index, 2), vanDerCorput(index, 3), vanDerCorput(index, 5));
    const std::optional<SurfaceHit> hit = rays.first(target + radius * direction, -direction);
    if (!hit) continue;
    hits += 1.0;
    backs += hit->back ? 1.0 : 0.0;
  }
  return hits > 0.0 ? backs / hits : 0.0;
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100.0 * share);
  return text;
}

// The limits separate about a hundred models by others: rooms start at 0.47 (closed) or 0.15 (a cave with back faces
// outside); machines with cavities reach 0.28, with front faces outside.
void decide(ModelSurvey& survey) {
  // Rooms are larger than the objects in them; smaller cavities are vases, cups and drawers.
  constexpr double kRoom = 1.5;
  const bool large = survey.largest >= kRoom;
  const bool shell = survey.backOutside >= 0.4;
  const auto of = [](double share, const Phrase& what) { return what.arg(percent(share)); };
  const Phrase enclosed = of(survey.enclosed, Phrase::tr("%1 of the points within it are closed in by front sides"));
  if (survey.enclosed >= (large ? 0.4 : 0.7) || (large && shell && survey.enclosed >= 0.08)) {
    survey.kind = ModelKind::Interior;
    survey.reason = enclosed;
  } else if (large && survey.solid < 0.35 && survey.walled >= 0.3 && survey.floored >= 0.5) {
    survey.kind = ModelKind::Open;
    survey.reason =
        of(survey.walled, Phrase::tr("%1 of the points within it have a floor, walls around and sky above"));
  } else if (large && survey.solid < 0.35 && survey.floored >= 0.6) {
    survey.kind = ModelKind::Open;
    survey.reason = of(survey.floored, Phrase::tr("%1 of the points within it stand over a floor, below the sky"));
  } else {
    survey.reason = survey.solid >= 0.35
                        ? of(survey.solid, Phrase::tr("%1 of the points within it lie inside of it or see back sides"))
                        : of(survey.sky, Phrase::tr("%1 of the rays from points within it leave to the sky"));
  }
}

}  // namespace

const char* modelKindId(ModelKind kind) {
  switch (kind) {
    case ModelKind::Interior:
      return "interior";
    case ModelKind::Open:
      return "open";
    case ModelKind::Object:
      break;
  }
  return "object";
}

ModelSurvey surveyModel(const TriangleRays& rays) {
  ModelSurvey survey;
  if (rays.empty()) {
    survey.reason = Phrase::tr("it has no surface that hides what is behind it");
    return survey;
  }
  const Box core = rays.core();
  const glm::dvec3 size = core.size();
  survey.largest = std::max({size.x, size.y, size.z});
  int index = 0;
  for (int y = 0; y < kLayers; ++y) {
    for (int x = 0; x < kAcross; ++x) {
      for (int z = 0; z < kAcross; ++z) {
        ++index;
        const glm::dvec3 jitter(vanDerCorput(index, 2), vanDerCorput(index, 3), vanDerCorput(index, 5));
        const glm::dvec3 cell = (glm::dvec3(x, y, z) + 0.15 + 0.7 * jitter) / glm::dvec3(kAcross, kLayers, kAcross);
        survey.points.push_back(
            surveyed(rays, core.min + cell * size, fibonacciDirections(kSurveyRays, vanDerCorput(index, 7))));
      }
    }
  }
  const auto share = [&](auto is) {
    return static_cast<double>(std::count_if(survey.points.begin(), survey.points.end(), is)) /
           static_cast<double>(survey.points.size());
  };
  survey.solid = share([](const SurveyedPoint& p) { return p.solid(); });
  survey.enclosed = share([](const SurveyedPoint& p) { return p.enclosed(); });
  survey.walled = share([](const SurveyedPoint& p) { return p.walled(); });
  survey.floored = share([](const SurveyedPoint& p) { return p.floored(); });
  survey.backOutside = backFromOutside(rays);
  double sky = 0.0;
  for (const SurveyedPoint& point : survey.points) sky += point.sky;
  survey.sky = sky / static_cast<double>(survey.points.size());
  decide(survey);
  return survey;
}

}  // namespace boxprobe
