// The free space of a model as cells: where there is air, which cells see each other, what is indoors, and the distance
// to surfaces. Found by rays along the lines of the grid.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// The extent and rotation of the walls, and the height of the rooms.
struct WalledRegion {
  double yaw = 0.0;     ///< radians about +y, within 45 degrees, for walls at right angles
  Box bounds;           ///< of all upright surfaces, along the axes rotated by `yaw` about the world's origin
  double height = 0.0;  ///< median from floors to ceilings; without ceilings that of the walls
};

/// Nothing if hardly any surface is upright. Ignores a ground plane and isolated objects far away.
std::optional<WalledRegion> walledRegion(const SurfaceRays& rays);

/// Cells of equal size along the region's axes, x fastest, then y, then z.
struct FreeSpace {
  glm::dmat3 worldFromGrid{1.0};   ///< rotation
  glm::dvec3 first{0.0};           ///< centre of cell (0, 0, 0), along the grid's axes
  double cell = 0.0;               ///< scene units
  glm::ivec3 count{0};             ///< cells along each axis
  std::vector<std::uint8_t> open;  ///< bit 0, 1, 2: no surface between the centres of this cell and the next one along
                                   ///< x, y, z
  static constexpr int kCeilingBit = 3;   ///< of `open`: something is above
  static constexpr int kOutdoorsBit = 4;  ///< of `open`: below the sky, see outdoors()
  std::vector<float> depth;               ///< distance of the nearest surface or of the outdoors; 0: not indoors
  bool backsAreFronts = false;            ///< as given
  double backVolume = 0.0;                ///< of the space enclosed by back faces: solid, or a room with inverted faces

  /// Of a cell with depth: below the open sky as a court or a walled garden is, not below a hole in a roof. No room has
  /// cells of both kinds.
  bool outdoors(std::size_t index) const { return (open[index] >> kOutdoorsBit & 1) != 0; }

  glm::ivec3 at(std::size_t index) const;
  std::size_t index(const glm::ivec3& at) const;
  glm::dvec3 gridPosition(std::size_t index) const { return first + cell * glm::dvec3(at(index)); }
  glm::dvec3 worldPosition(std::size_t index) const { return worldFromGrid * gridPosition(index); }
  /// The neighbour of an indoor cell along `axis`, one step forward or back, if it is indoors and no surface is
  /// between.
  std::optional<std::size_t> neighbour(std::size_t index, int axis, bool forward) const;
};

/// A cell is indoors if it has a floor below and is enclosed: below a ceiling, 12 of 18 directions must meet a surface;
/// in a court without a ceiling, 14 within six times the rooms' height. `backsAreFronts`: for models with inverted
/// faces. Cells are a tenth to a fortieth of the rooms' height, 20 cm if that is in the range, larger if there would be
/// more than three million. Nothing if `progress` stopped it.
std::optional<FreeSpace> freeSpace(const SurfaceRays& rays, const WalledRegion& region, bool backsAreFronts,
                                   const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
