// What stands between two points of a scene. The interface is here, so that whatever derives visibilities knows no ray
// tracer; filters/fit/rays has the one that traces triangles, for programs that link it.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

class SightLines {
 public:
  struct Met {
    double distance = 0.0;    ///< scene units
    bool back = false;        ///< the side was met from which the triangle's corners run clockwise
    glm::dvec3 normal{0.0};   ///< unit, world, on the side that was met
    glm::vec3 albedo{0.0f};   ///< light scattered over light received, mean over its textures; a metal counts as matt
    glm::vec3 emitted{0.0f};  ///< radiance that it shines with on the side that was met, mean over its textures
  };

  virtual ~SightLines() = default;
  /// Is there no surface at all?
  virtual bool empty() const = 0;
  /// Does a surface stand between two points (world)? The segment's ends count as parts of it. `shining`: also if that
  /// surface shines all over; a light source within its own lampshade is not hidden by it. Safe from any thread.
  virtual bool blocked(const glm::dvec3& from, const glm::dvec3& to, bool shining) const = 0;
  /// The first surface from `from` along `direction` (unit), world; nothing: the sky.
  virtual std::optional<Met> first(const glm::dvec3& from, const glm::dvec3& direction) const = 0;
  /// Around all surfaces, world; a point at the origin if there is none.
  virtual Box bounds() const = 0;
};

/// Sight lines through a scene as it stands still; `models` in the order of scene.models. Throws WorkError.
using SightLinesMaker = std::function<std::shared_ptr<const SightLines>(
    const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models)>;

}  // namespace boxprobe
