// What the truth scenes have in common: a closed room of painted walls with lamps in them, a floor to judge, and boxes
// of which every side is painted differently. Called by the scenes.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "data/scenes/composer.h"
#include "data/scenes/mural_wall.h"

namespace boxprobe::scenes {

/// Edges in the scenes' pictures, metres: wider than a texel, so that both renderers see the same.
constexpr double kSoft = 0.08;

struct RoomShell {
  glm::dvec3 low, size;
  /// Where lamps begin and end, metres from `low`, the room's length last.
  std::vector<double> cutsX, cutsY, cutsZ;
  struct Side {
    Mural mural;
    std::vector<WallLamp> lamps;  ///< x to the right as seen from inside; of the ceiling, x east and y south
  };
  Side north, east, south, west, ceiling;
  Mural carpet;  ///< what probes have in place of the floor
};

/// Nodes `floor`, `carpet`, `wall north`, `wall east`, `wall south`, `wall west`, `ceiling` and the lamps.
void addShell(Composer& scene, const RoomShell& shell);

/// White metal, roughness 0, as node and material `floor`.
void addFloor(Composer& scene, glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up);

/// A picture of six columns, one for each side of a box.
Picture sidesPicture(const std::string& name, const std::vector<glm::dvec3>& sixColors, double bandMetres);
/// Where the sides of a box up to 4 m long find theirs in it.
FaceUv sidesOfPicture();

}  // namespace boxprobe::scenes
