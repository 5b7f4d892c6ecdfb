// Light sources on a surface, summed as in the spliced shader.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/core/surface/surface_point.h"

namespace boxprobe {

/// Factors on the reflections of base and coat that add back what meets more than one microfacet.
struct Scattering {
  glm::vec3 base{1.0f}, coat{1.0f};
};

/// Both lobes and the coat, before ambient occlusion. `f0` and `f90` as in the shader; `through`: transmittance for
/// each light, null for 1.
glm::vec3 directLight(const SurfacePoint& surface, const glm::vec3& f0, const glm::vec3& f90,
                      const std::vector<Light>& lights, const std::vector<glm::vec3>* through = nullptr,
                      const Scattering& scattering = {});

}  // namespace boxprobe
