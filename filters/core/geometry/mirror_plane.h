// The plane of a planar mirror, found from its geometry, or an error that says where it is wrong.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// World space, in double.
struct MirrorPlane {
  glm::dvec3 center{0.0};
  glm::dvec3 normal{0.0, 0.0, 1.0};     ///< unit, on the reflecting side
  std::array<glm::dvec3, 4> corners{};  ///< of a rectangle in the plane that holds all of it, in order around it
  bool bothSides = false;               ///< of a double-sided material
};

/// The plane of all geometry of that node. Nothing if no instance has the name (a remark, not an error: see
/// unmatchedOverrides). Throws FieldError {"mirrors", NODE} if the geometry does not lie in one plane and face one way.
std::optional<MirrorPlane> mirrorPlane(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                                       const std::string& node);

/// Checks every mirror of the scene as above: throws at the first that does not lie in one plane.
void checkMirrors(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models);

}  // namespace boxprobe
