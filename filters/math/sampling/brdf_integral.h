// How much of white light a rough surface reflects, integrated. Called by the generator of the split-sum table
// (write_brdf_table.cpp), when the project is built, and by tests. Double precision; knows no table.
#pragma once

#include <glm/vec2.hpp>

namespace boxprobe {

/// Albedos of single-scatter GGX with height-correlated Smith masking (Heitz 2014, equation 99), seen at `cosine` =
/// N.V in (0, 1], perceptual `roughness` in [0, 1]: x scales F0, y scales F90 of Schlick's Fresnel. Gauss-Legendre over
/// half vectors, `points` each way, between the angles where the integrand has kinks; 32 leave less than 2e-5.
glm::dvec2 integrateBrdf(double cosine, double roughness, int points = 32);

}  // namespace boxprobe
