// What the window's own frames leave out of the scene, and what they mark; explanations are of those frames. Captures,
// linear pictures, mirrors and shadows show everything.
#pragma once

#include <glm/common.hpp>
#include <optional>
#include <set>
#include <string>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A fitted box lies on its walls: this share of its half size counts as wall on each side.
constexpr double kCutWallShare = 0.02;

/// What stands between the eye and this box is not drawn, where the box would be seen.
struct CutBox {
  Box box;                          ///< see Box
  glm::dvec3 rotationDegrees{0.0};  ///< about its centre, as a probe's
  /// Where the box begins for the cut. Never zero.
  glm::dvec3 halfSize() const { return glm::max((1.0 - kCutWallShare) * 0.5 * box.size(), glm::dvec3(1.0e-6)); }
  bool operator==(const CutBox& o) const { return box == o.box && rotationDegrees == o.rotationDegrees; }
};

struct WindowView {
  std::set<std::string> hidden;    ///< objects, by node
  std::optional<CutBox> cutaway;   ///< nothing: nothing is cut
  std::set<std::string> outlined;  ///< objects that have an outline, by node
  bool operator==(const WindowView& o) const {
    return hidden == o.hidden && cutaway == o.cutaway && outlined == o.outlined;
  }
};

}  // namespace boxprobe
