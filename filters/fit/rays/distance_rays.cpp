// See distance_rays.h.
#include "filters/fit/rays/distance_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/math/cube/distance_cube.h"

namespace boxprobe {

DistanceRays::DistanceRays(const CubeMap& distance, const glm::dvec3& originWorld, const glm::dmat3& worldFromMap)
    : distance_(distance), origin_(originWorld), worldFromMap_(worldFromMap), bounds_{originWorld, originWorld} {
  const DistanceCube cube(distance_);
  for (const glm::dvec3& direction : fibonacciDirections(4096)) {
    const double seen = cube.fetchDistance(glm::vec3(direction));
    farthest_ = std::max(farthest_, seen);
    const glm::dvec3 position = origin_ + worldFromMap_ * (seen * direction);
    bounds_ = {glm::min(bounds_.min, position), glm::max(bounds_.max, position)};
  }
}

std::optional<SurfaceHit> DistanceRays::first(const glm::dvec3& origin, const glm::dvec3& direction) const {
  const DistanceCube cube(distance_);
  const glm::dmat3 mapFromWorld = glm::transpose(worldFromMap_);
  const glm::dvec3 from = mapFromWorld * (origin - origin_), along = mapFromWorld * direction;
  const double reach = 2.0 * farthest_ + glm::length(from);
  if (!(reach > 0.0)) return std::nullopt;
  const float t = shading::trueHitDistance(&cube, shading::ProbeShape{}, static_cast<float>(distance_.faceSize()),
                                           glm::vec3(from), glm::vec3(along), static_cast<float>(reach));
  if (!(t < reach)) return std::nullopt;
  SurfaceHit hit;
  hit.distance = t;
  hit.normalWorld = worldFromMap_ * normalAt(from + hit.distance * along);
  if (glm::dot(hit.normalWorld, direction) > 0.0) hit.normalWorld = -hit.normalWorld;
  return hit;
}

/// The normal of the plane through the points that three neighbouring texels saw.
glm::dvec3 DistanceRays::normalAt(const glm::dvec3& positionMap) const {
  const DistanceCube cube(distance_);
  const float size = static_cast<float>(distance_.faceSize());
  const CubePoint point = cubePoint(glm::vec3(positionMap));
  const auto seen = [&](float s, float t) {
    const glm::vec3 direction = shading::cubeDirection(point.face, s, t);
    return glm::dvec3(glm::normalize(direction) * cube.fetchDistance(direction));
  };
  const auto centre = [size](float x) {
    return (std::clamp(std::floor((0.5f * x + 0.5f) * size), 0.0f, size - 1.0f) + 0.5f) * 2.0f / size - 1.0f;
  };
  const float s = centre(point.s), t = centre(point.t), step = 2.0f / size;
  const glm::dvec3 here = seen(s, t);
  const glm::dvec3 n =
      glm::cross(seen(s + (s > 0.0f ? -step : step), t) - here, seen(s, t + (t > 0.0f ? -step : step)) - here);
  const double length = glm::length(n);
  return length > 0.0 ? n / length : -glm::normalize(positionMap);
}

}  // namespace boxprobe
