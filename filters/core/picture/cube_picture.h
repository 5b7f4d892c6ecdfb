// A cubemap as a flat picture, a cross or a latitude-longitude map, seen from inside, and the positions of directions
// and texels in it, so that lookups can be drawn on top.
//
// Both pictures show what someone inside sees, +Y up, with +Z in the middle and +X to its left (the world is
// right-handed). The latitude-longitude map is OpenEXR's: the left edge is -Z, the top row +Y. The cross is
//
//           +Y
//     +X    +Z    -X    -Z
//           -Y
//
// OpenGL stores faces as seen from outside: every face is flipped left to right here.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/math/cube/cube_map.h"

namespace boxprobe {

enum class CubePictureKind { Cross, LatLong };

/// Positions in such a picture: pixels from the top left corner, pixel centres at .5.
class CubePicture {
 public:
  /// `width` is rounded down to a multiple of 4 (cross) or 2 (latitude-longitude), at least 4.
  CubePicture(CubePictureKind kind, int width);

  CubePictureKind kind() const { return kind_; }
  int width() const { return width_; }
  int height() const { return kind_ == CubePictureKind::Cross ? 3 * width_ / 4 : width_ / 2; }

  /// `direction` need not be unit.
  glm::dvec2 position(const glm::vec3& direction) const;
  /// Not unit; nothing outside the picture and in the empty corners of the cross.
  std::optional<glm::vec3> direction(const glm::dvec2& position) const;
  /// The outline of a texel of a face of `faceSize`² texels; the first point is not repeated. On the latitude-longitude
  /// map neighbouring points are never half a picture apart: an outline across the seam continues beyond the picture's
  /// edge (draw it again shifted by the width), and one around a pole does not close.
  std::vector<glm::dvec2> texelOutline(int faceSize, int face, int column, int row) const;

 private:
  glm::dvec2 facePosition(const CubePoint& point) const;

  CubePictureKind kind_;
  int width_;
};

/// A level in display colours. Texels larger than a pixel are squares in the cross and interpolated, as lookups do, on
/// the latitude-longitude map; smaller ones are averaged in linear light. Opaque except for the cross's empty corners.
ImageRgba8 drawCubePicture(const CubeMap& cube, int level, const CubePicture& picture, float exposure,
                           Tone tone = Tone::None);

}  // namespace boxprobe
