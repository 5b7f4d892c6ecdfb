// The albedo of a lobe, integrated by the references' own rays, for terms that are not sampled: multiple scattering,
// and the sky as captures reflect it. They do not read the renderer's table, because they judge it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Factors of F0 and F90 of Schlick's Fresnel for `nDotV` in (0, 1] and perceptual `roughness` in [0, 1]; error below
/// 0.003. The first call makes a table, in about a tenth of a second.
glm::dvec2 lobeAlbedo(double nDotV, double roughness);

/// The factor that adds back light that meets more than one microfacet (Turquin 2019): what a single reflection loses
/// of white light comes out coloured by `f0`. Arguments as above; a smaller `nDotV` counts as grazing.
glm::dvec3 multipleScatteringFactor(const glm::dvec3& f0, double nDotV, double roughness);

}  // namespace boxprobe
