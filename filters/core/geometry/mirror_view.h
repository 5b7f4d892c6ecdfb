// The view into a planar mirror: the eye and its axes mirrored about the plane, the part of the picture the mirror
// covers, and a projection whose near plane is the mirror. Plain mathematics in double, for perspective and parallel
// projection alike; called by the mirrors' renderer; knows no GL.
//
// Forward and up are mirrored, right is not: it follows from them as for any camera. So the picture comes out with left
// and right exchanged instead of with its triangles wound the other way, no culling has to be turned round, and whoever
// looks it up projects with the same matrix.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "filters/core/geometry/mirror_plane.h"

namespace boxprobe {

/// A camera and the size of its picture. Clip space as OpenGL has it.
struct PictureView {
  glm::dvec3 eye{0.0};  ///< world
  glm::dvec3 forward{0.0, 0.0, -1.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  bool parallel = false;
  glm::dmat4 clipFromView{1.0};
  int width = 1, height = 1;  ///< pixels

  /// World axes, from the eye: positions are given relative to it.
  glm::dmat4 viewFromEye() const;
};

/// Pixels of the mirrored picture, from its lower left; may reach beyond it.
struct MirrorRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Does the eye see the reflecting side? A mirror of both sides is turned towards the eye.
bool facesEye(MirrorPlane& plane, const PictureView& view);

/// What is visible of the mirror's rectangle, as a polygon in the picture from -1 to 1; empty if nothing is.
std::vector<glm::dvec2> visiblePart(const MirrorPlane& plane, const PictureView& view);
/// In pixels.
double areaOf(const std::vector<glm::dvec2>& polygon, const PictureView& view);

/// The pixels that such a polygon covers in the mirrored picture, and `margin` more on every side, out to a grid of
/// `kRectGrid` pixels: a camera that moves does not change the size of what is drawn into with every frame.
constexpr int kRectGrid = 32;
MirrorRect mirroredRect(const std::vector<glm::dvec2>& polygon, const PictureView& view, double margin);

/// The camera behind the mirror that sees `rect` of the mirrored picture and nothing on its own side of the mirror.
/// `farDistance`: along its view, no less than what is to be seen.
PictureView mirroredView(const MirrorPlane& plane, const PictureView& view, const MirrorRect& rect, double farDistance);

/// `clipFromView` with its near plane replaced by `planeView` (a x + b y + c z + d = 0, above 0 on the side that is
/// seen), after Lengyel 2005, "Oblique View Frustum Depth Projection and Clipping", in its form for any projection.
glm::dmat4 withNearPlane(const glm::dmat4& clipFromView, const glm::dvec4& planeView);

}  // namespace boxprobe
