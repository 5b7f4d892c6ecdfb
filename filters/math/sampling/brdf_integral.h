// The directional albedo of a rough surface, integrated in double precision. The split-sum table is made from it when
// the project is built (write_brdf_table.cpp).
#pragma once

#include <glm/vec2.hpp>

namespace boxprobe {

/// Albedos of single-scatter GGX with height-correlated Smith masking (Heitz 2014, equation 99) for `cosine` = N.V in
/// (0, 1] and perceptual `roughness` in [0, 1]: x scales F0, y scales F90 of Schlick's Fresnel. Gauss-Legendre over
/// half vectors with `points` nodes per dimension, between the angles where the integrand has kinks; 32 leave an error
/// below 2e-5.
glm::dvec2 integrateBrdf(double cosine, double roughness, int points = 32);

}  // namespace boxprobe
