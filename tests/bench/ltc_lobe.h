// Linearly transformed cosines (Heitz, Dupuy, Hill, Neubelt 2016), the measured peer of shaders/shared/lamp_lobe.glsl:
// a polygon's light in a GGX lobe as the form factor of the polygon seen through a matrix. The matrix is fitted here,
// for just the roughness and the angle that are asked for, by the paper's own error; so no step of a table counts
// against it. Bench only.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "tests/support/lamp_truth.h"

namespace boxprobe::test {

struct LtcLobe {
  glm::dmat3 inverse{1.0};  ///< from the frame of the normal (z) and the view (y = 0) into that of the cosine
  glm::dvec2 albedo{0.0};   ///< of the whole lobe: what F0 and F90 are multiplied by, exact
  double fit = 0.0;         ///< the error that is left of the fit, as the paper counts it

  /// What is reflected of a lamp: F0 times x plus F90 times y.
  glm::dvec2 glossy(const LampCase& lamp) const;
};

/// Of height-correlated GGX, alpha = roughness squared, seen under `elevation` radians above the surface.
LtcLobe fitLtc(double roughness, double elevation);

}  // namespace boxprobe::test
