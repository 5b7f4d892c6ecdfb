// Which handles there are, where they stand on the screen and which one is under the pointer; the ray through a pixel.
// Called by the probe widget and, for its answers, by tests. Knows a camera, no actors and no mouse buttons.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/gui/handles/handle_drag.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/scene/scene.h"

class vtkCamera;

namespace boxprobe {

enum class HandleKind { Face, Origin };

/// A thing that can be taken hold of: a face or the origin of the selected probe, or the origin of another one, which
/// selects that.
struct Handle {
  HandleKind kind = HandleKind::Origin;
  std::size_t probe = 0;
  BoxFace face;  ///< of HandleKind::Face
  bool operator==(const Handle& o) const {
    return kind == o.kind && probe == o.probe && (kind == HandleKind::Origin || face == o.face);
  }
};

std::vector<Handle> handles(const std::vector<Probe>& probes, std::optional<std::size_t> selected);
glm::dvec3 handlePositionWorld(const std::vector<Probe>& probes, const Handle& handle);

/// A camera seen through a viewport of so many pixels. Pixels count from the top left; y grows downwards.
class ViewProjection {
 public:
  ViewProjection(vtkCamera* camera, double widthPixels, double heightPixels);

  /// Nothing for a point behind the viewer.
  std::optional<glm::dvec2> pixel(const glm::dvec3& pointWorld) const;
  Ray ray(const glm::dvec2& pixel) const;
  ViewAxes axes() const { return {forward_, up_}; }
  glm::dvec3 eyeWorld() const { return eye_; }
  glm::dvec3 right() const { return right_; }
  /// World length of one pixel at that point.
  double metresPerPixel(const glm::dvec3& pointWorld) const;

 private:
  glm::dvec3 eye_, forward_, right_, up_;
  double halfHeight_;  ///< tangent of half the vertical field of view; half the height in a parallel projection
  double width_, height_;
  bool parallel_;
};

/// The handle whose centre is nearest to `pixel` and not farther than `reachPixels`; of two as near, the one closer to
/// the viewer.
std::optional<Handle> handleAt(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                               const ViewProjection& view, const glm::dvec2& pixel, double reachPixels);

}  // namespace boxprobe
