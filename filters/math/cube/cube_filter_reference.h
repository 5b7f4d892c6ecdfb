// What a level of a prefiltered chain should be: the kernel integrated over every texel of the source, without a
// sampling pattern or a mip chain. Tests and the benchmark judge both prefilters by it; it is too slow for the program.
#pragma once

#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

/// The source's radiance is its level 0 as lookups show it: bilinear and seamless. The integral is a sum over a tree of
/// patches. A patch that is small beside the kernel's scale at its angle counts as one direction, the centroid of its
/// radiance; any other is split, down to a ninth of a texel.
class CubeFilterReference {
 public:
  /// `tolerance`: width of a patch relative to the kernel's scale there. The error of a smooth integrand is
  /// proportional to its square.
  explicit CubeFilterReference(const CubeMap& source, float tolerance = 0.1f);

  glm::vec4 value(const FilterLobe& lobe, const glm::vec3& middle) const;
  /// Fills a level of `chain` by value(), on all cores.
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
