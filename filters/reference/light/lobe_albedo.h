// How much of even light a lobe reflects, by the references' own rays: for what they add to their rays' sum, the
// multiple scattering and the sky as a capture reflects it. They do not read the renderer's table, which they judge.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Factors of F0 and F90 of Schlick's Fresnel, seen at `nDotV` in (0, 1], perceptual `roughness` in [0, 1]; off by less
/// than 0.003. The first call makes a table, in about a tenth of a second.
glm::dvec2 lobeAlbedo(double nDotV, double roughness);

/// Factor that adds back what meets more than one microfacet (Turquin 2019): what one reflection loses of white light
/// comes out coloured by `f0`. Arguments as above; a smaller `nDotV` counts as grazing.
glm::dvec3 scatteredBack(const glm::dvec3& f0, double nDotV, double roughness);

}  // namespace boxprobe
