// The free space of a model as cells: where air is, which cells see each other, what is indoors and how far surfaces
// are. Found by rays along the lines of the grid alone. Called by find_rooms.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/fit/rays/surface_rays.h"

namespace boxprobe {

/// Where walls stand, how they are turned, and how high rooms are.
struct WalledRegion {
  double yaw = 0.0;     ///< radians about +y, within 45 degrees, of walls at right angles
  Box bounds;           ///< of all upright surfaces, along the axes turned by `yaw` about the world's origin
  double height = 0.0;  ///< median from floors to ceilings; of a place without ceilings that of the walls
};

/// Nothing where hardly any surface stands upright. A plain under everything does not count, nor does a lone thing far
/// away.
std::optional<WalledRegion> walledRegion(const SurfaceRays& rays);

/// Cells of equal size along the region's axes, ordered x first, then y, then z.
struct FreeSpace {
  glm::dmat3 worldFromGrid{1.0};   ///< rotation
  glm::dvec3 first{0.0};           ///< middle of cell (0, 0, 0), along the grid's axes
  double cell = 0.0;               ///< scene units
  glm::ivec3 count{0};             ///< cells along each axis
  std::vector<std::uint8_t> open;  ///< bit 0, 1, 2: nothing stands between this cell's middle and the next one along
                                   ///< x, y, z
  static constexpr int kCeilingBit = 3;  ///< of `open`: something is above
  std::vector<float> depth;              ///< distance of the nearest surface or of what is outdoors; 0: not indoors
  bool backsAreFronts = false;           ///< as asked for
  double backVolume = 0.0;               ///< of the space closed in by back sides: solid, or a room with inverted faces

  glm::ivec3 at(std::size_t index) const;
  std::size_t index(const glm::ivec3& at) const;
  glm::dvec3 gridPosition(std::size_t index) const { return first + cell * glm::dvec3(at(index)); }
  glm::dvec3 worldPosition(std::size_t index) const { return worldFromGrid * gridPosition(index); }
  /// The neighbour of an indoor cell along `axis`, a step forward or back, if it is indoors and nothing stands between.
  std::optional<std::size_t> neighbour(std::size_t index, int axis, bool forward) const;
};

/// A cell is indoors that has a floor below and is closed in: of 18 directions 12 meet something below a ceiling; in a
/// court without one, 14 within six times the rooms' height. `backsAreFronts`: of a model whose faces are inverted.
/// Cells are a tenth to a fortieth of the rooms' height, 20 cm where that allows it, larger where there would be more
/// than three million. Nothing if `progress` stopped it.
std::optional<FreeSpace> freeSpace(const SurfaceRays& rays, const WalledRegion& region, bool backsAreFronts,
                                   const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
