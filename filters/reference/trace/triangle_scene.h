// A scene's models as triangle arrays in the world, with all overrides applied: the input of the ray tracer.
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
  Material material;      ///< with the scene's overrides
  bool inPicture = true;  ///< visible to the camera
  bool inProbes = true;   ///< visible to probes: includes stand-ins, excludes what all probes hide
  /// Arrays as in Mesh, those that are not empty with one entry a position.
  std::vector<glm::vec3> positions;  ///< relative to the anchor, world axes, scene units
  std::vector<glm::vec3> normals;    ///< world; as the shader interpolates them, not necessarily unit
  std::vector<glm::vec4> tangents;   ///< w: handedness
  std::vector<glm::vec2> uv, uv1;
  std::vector<glm::vec4> colors;
  std::vector<std::uint32_t> indices;
};

struct TriangleScene {
  glm::dvec3 anchorWorld{0.0};  ///< the middle of everything: preserves precision in a scene far from the origin
  double radius = 1.0;          ///< all positions are within this distance of the anchor
  std::vector<TracedObject> objects;
};

/// `models` in the order of scene.models. An object is hidden from probes if every probe hides it, or if it is dynamic
/// and no probe is realtime.
TriangleScene makeTriangleScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
