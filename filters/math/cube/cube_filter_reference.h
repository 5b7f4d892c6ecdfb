// What a level of a prefiltered chain should be: the kernel integrated over every texel of the source, with no sampling
// pattern and no mip chain. Judges both prefilters, in tests and in the benchmark; too slow for the program.
#pragma once

#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

/// The source's radiance is taken as its level 0 shows it when looked up: interpolated bilinearly, seamlessly. The
/// integral is a sum over a tree of patches: a patch that is small beside the kernel's scale at its angle counts as one
/// direction, the centroid of its radiance; any other is split, down to a ninth of a texel.
class CubeFilterReference {
 public:
  /// `tolerance`: width of a patch relative to the kernel's scale there; the error of a smooth integrand goes with its
  /// square.
  explicit CubeFilterReference(const CubeMap& source, float tolerance = 0.1f);

  glm::vec4 value(const FilterLobe& lobe, const glm::vec3& middle) const;
  /// A level of `chain` from value(), on all cores.
  void filterLevel(const FilterLobe& lobe, CubeMap& chain, int level) const;

 private:
  struct Patch {
    glm::vec3 direction;  // centroid
    float solidAngle;
    glm::vec4 flux;
    float width;  // the largest distance across
  };
  int faceSize_;
  float tolerance_;
  /// Ninths of texels, then texels, then 2 x 2 of the level before, to one per face; each as six faces of rows.
  std::vector<std::vector<Patch>> levels_;
  std::vector<int> sizes_;
};

}  // namespace boxprobe
