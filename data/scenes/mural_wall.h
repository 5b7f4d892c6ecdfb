// A rectangular wall of a room, painted by a formula in metres, with lamps cut out of it that lie in its plane. Called
// by the scenes of rooms that are exactly their probe's box; knows nothing of the other walls but the cuts they share.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "data/scenes/composer.h"
#include "data/scenes/mesh_builder.h"

namespace boxprobe::scenes {

/// A rectangle of a wall's own grid, in metres along it.
struct Patch {
  double left, right, low, high;
  bool holds(double x, double y) const { return x > left && x < right && y > low && y < high; }
};

class MuralWall {
 public:
  /// `corner` is lower left, `right` and `up` its edges as seen from the front. Cuts are fractions of the edges, 0 and
  /// 1 included: every border of a lamp, and what the neighbouring walls are cut by at the edge they share.
  MuralWall(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, std::vector<double> rightCuts,
            std::vector<double> upCuts);

  /// The cells of which `keep(x, y)` wants the middle, metres from the lower left.
  MeshBuilder part(const std::function<bool(double x, double y)>& keep, UvRectangle uv = {}) const;
  glm::dvec2 size() const;  ///< metres

 private:
  glm::dvec3 corner_, right_, up_;
  std::vector<double> rightCuts_, upCuts_;
};

struct WallLamp {
  const char* name;
  Patch patch;
  glm::vec3 radiance;
};

/// Linear colour at a place of a wall, metres from its lower left.
using Mural = glm::dvec3 (*)(double x, double y);

/// The wall, unlit, as node and material `name`, and its lamps by their names.
void addWall(Composer& scene, double texelsPerMetre, const std::string& name, const MuralWall& wall, Mural mural,
             const std::vector<WallLamp>& lamps);

/// Of a wall that runs the other way.
std::vector<double> reversed(std::vector<double> cuts);
/// Of cuts in metres, the last of which is the wall's length.
std::vector<double> fractions(std::vector<double> metres);

}  // namespace boxprobe::scenes
