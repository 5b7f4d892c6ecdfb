// A scene's models as triangle arrays in the world, every override applied: all that the ray tracer is given. Called by
// whoever traces; knows no ray.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

struct TracedObject {
  std::string node;
  Material material;      ///< the scene's overrides applied
  bool inPicture = true;  ///< what the camera sees
  bool inProbes = true;   ///< what the probes see: stand-ins, and nothing they hide
  /// Arrays as in Mesh, those that are not empty with one entry a position.
  std::vector<glm::vec3> positions;  ///< relative to the anchor, world axes, scene units
  std::vector<glm::vec3> normals;    ///< world; unit or not, as the shader interpolates them
  std::vector<glm::vec4> tangents;   ///< w: handedness
  std::vector<glm::vec2> uv, uv1;
  std::vector<glm::vec4> colors;
  std::vector<std::uint32_t> indices;
};

struct TriangleScene {
  glm::dvec3 anchorWorld{0.0};  ///< middle of everything: keeps the digits of a scene far from the origin
  double radius = 1.0;          ///< no position is farther from the anchor
  std::vector<TracedObject> objects;
};

/// `models` in the order of scene.models. An object counts as hidden from the probes if each probe hides it, or if it
/// moves and no probe is realtime.
TriangleScene makeTriangleScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
