// How much of even light a lobe reflects, by the references' own rays: for what they add to their rays' sum, the
// multiple scattering and the sky as a capture reflects it. They do not read the renderer's table, which they judge.
#pragma once

#include <glm/vec2.hpp>

namespace boxprobe {

/// Factors of F0 and F90 of Schlick's Fresnel, seen at `nDotV` in (0, 1], perceptual `roughness` in [0, 1]; off by less
/// than 0.003. The first call makes a table, in about a tenth of a second.
glm::dvec2 lobeAlbedo(double nDotV, double roughness);

}  // namespace boxprobe
