// The view into a planar mirror: the eye and its axes mirrored about the plane, the part of the picture that the mirror
// covers, and a projection whose near plane is the mirror. In double precision, for perspective and parallel
// projection.
//
// Forward and up are mirrored; right follows from them as for any camera. So the picture comes out flipped left to
// right, and triangles keep their winding: culling stays as it is, and lookups project with the same matrix.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "filters/core/geometry/mirror_plane.h"

namespace boxprobe {

/// A camera and the size of its picture. Clip space as in OpenGL.
struct PictureView {
  glm::dvec3 eye{0.0};  ///< world
  glm::dvec3 forward{0.0, 0.0, -1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  bool parallel = false;
  glm::dmat4 clipFromView{1.0};
  int width = 1, height = 1;  ///< pixels

  /// Rotation from world axes to the view; positions are given relative to the eye.
  glm::dmat4 viewFromEye() const;
};

/// A rectangle of pixels of the mirrored picture, from its lower left; may extend beyond it.
struct MirrorRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Does the eye see the reflecting side? A two-sided mirror is turned towards the eye.
bool facesEye(MirrorPlane& plane, const PictureView& view);

/// The visible part of the mirror's rectangle, as a polygon in the picture from -1 to 1; empty if nothing is visible.
std::vector<glm::dvec2> visiblePart(const MirrorPlane& plane, const PictureView& view);
/// Area of such a polygon in pixels.
double areaOf(const std::vector<glm::dvec2>& polygon, const PictureView& view);

/// The pixels that such a polygon covers in the mirrored picture, with a `margin` on every side, rounded out to a grid
/// of `kRectGrid` pixels: a moving camera then does not change the size of the target in every frame.
constexpr int kRectGrid = 32;
MirrorRect mirroredRect(const std::vector<glm::dvec2>& polygon, const PictureView& view, double margin);

/// The camera behind the mirror that sees `rect` of the mirrored picture, and nothing on its own side of the mirror.
/// `farDistance`: along its view, at least as far as what has to be visible.
PictureView mirroredView(const MirrorPlane& plane, const PictureView& view, const MirrorRect& rect, double farDistance);

/// `clipFromView` with its near plane replaced by `planeView` (a x + b y + c z + d = 0, positive on the visible side),
/// after Lengyel 2005, "Oblique View Frustum Depth Projection and Clipping", in its form for any projection.
glm::dmat4 withNearPlane(const glm::dmat4& clipFromView, const glm::dvec4& planeView);

}  // namespace boxprobe
