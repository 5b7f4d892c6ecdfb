// The light of lamps as shapes in long double, from its definitions: the polygon's form factor, and its image among the
// visible normals with the splits and weights that shaders/shared/lamp_lobe.glsl states. Shares nothing with shaders/.
// Inputs are floats taken as exact. Called by subject_lamp.
#pragma once

#include <array>
#include <vector>

#include "filters/stress/exact.h"

namespace boxprobe::stress::exact {

struct Lamp {
  std::vector<Vec> corners;  ///< in the frame of the position, counterclockwise as the shining side is seen
  bool bothSides = false;
};

/// Height of the position above the lamp's plane on its shining side, in units of the least that counts: 1e-5 of the
/// lamp's first two sides. Between -1 and 1 nothing is seen; 0 for a lamp without area.
Real heightOverLamp(const Lamp& lamp, const Vec& position);

/// Share of the hemisphere's cosine about `normal` that the polygon fills; from whichever side.
Real formFactor(const Lamp& lamp, const Vec& position, const Vec& normal);

/// What a surface reflects of a lamp of radiance 1: F0 times the one plus F90 times the other. `tie`: by how much, in
/// cosines, one part of an edge must be longer than the other to be the one that is split once more; a value that
/// depends on its sign has no definition better than rounding.
std::array<Real, 2> imageShare(const Lamp& lamp, const Vec& position, const Vec& normal, const Vec& view,
                               Real roughness, Real tie);

}  // namespace boxprobe::stress::exact
