// The lamps of a scene: what shines much brighter than the rest of it, as flat convex polygons. Their light on diffuse
// and rough surfaces is exact from the polygon alone (shaders/shared/lamp.glsl), and a probe's map, coarse and seen
// from one point, need not hold them. Plain values; knows neither VTK nor files.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/file_limits.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/shared/lamp_math.h"

namespace boxprobe {

/// One polygon of a lamp.
struct SceneLamp {
  std::string node;      ///< the object it belongs to
  std::string material;  ///< may be empty
  /// World, 3 to shading::kLampCorners, counterclockwise as the shining side is seen. A round lamp's polygon has its
  /// area and its middle.
  std::vector<glm::dvec3> corners;
  glm::dvec3 middle{0.0};    ///< centroid, world
  glm::dvec3 normal{0.0};    ///< unit, on the shining side
  glm::dvec3 radiance{0.0};  ///< linear; the mean of a textured emission
  bool bothSides = false;
  double area = 0.0;   ///< scene units squared
  double power = 0.0;  ///< flux: pi times area and mean radiance, of both sides if both shine
  /// Polygons that touch, a box's six faces: they are drawn as shapes together or not at all.
  std::size_t group = 0;
  /// Index into Scene::lights of a point or spot light at its place, which stands for the same lamp: counted once,
  /// by the lamp's shape.
  std::optional<std::size_t> light;
};

struct SceneLamps {
  std::vector<SceneLamp> lamps;  ///< by falling power
  /// What shines and is no lamp, and what of a lamp is not as it looks: one sentence each, the key path first.
  std::vector<std::string> remarks;
};

/// Polygons that a probe draws as shapes at most.
constexpr std::size_t kMostProbeLamps = 8;

/// Of the objects that baked probes see: `models` in the order of scene.models, overrides applied. Triangles of an
/// object that lie in one plane and share edges become one polygon, or several if it is not convex. What is not taken
/// stays in the probes' maps: surfaces no brighter than four times the mean over all surfaces; curved ones, of more
/// than kMostProbeLamps polygons; an object with which there would be more than limits::kLampTriangles; triangles
/// without area.
SceneLamps sceneLamps(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

/// Those that a probe draws as shapes, as indices, by falling power: groups that meet its box, shine into it and are
/// not hidden from it, by their power, while they are at most `most` polygons together.
std::vector<std::size_t> probeLamps(const std::vector<SceneLamp>& lamps, const Probe& probe,
                                    std::size_t most = kMostProbeLamps);

/// The same whatever the probe's box: those that can give most at its capture origin, with no wall between, as indices,
/// the strongest group first.
std::vector<std::size_t> captureLamps(const std::vector<SceneLamp>& lamps, const Probe& probe,
                                      std::size_t most = kMostProbeLamps);

/// Relative to a point in the world, in the axes whose world coordinates are the columns of `worldFromFrame`.
LampPolygon lampPolygon(const SceneLamp& lamp, const glm::dvec3& originWorld,
                        const glm::dmat3& worldFromFrame = glm::dmat3(1.0));

}  // namespace boxprobe
