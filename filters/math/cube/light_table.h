// A table to sample directions by a probe's light: its level 0 in cells of equal size on the faces, each drawn in
// proportion to its brightness. An alias table (Walker 1977, Vose 1991) makes a draw cost one lookup, however many
// cells there are. Techniques sample it through shaders/shared/light_sampling.glsl, on the CPU and, as a texture, on
// the GPU.
#pragma once

#include <atomic>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

struct LightTable {
  static constexpr int kLargestFace = 64;
  int faceSize = 0;  ///< cells along a face; 0: nothing is bright
  /// 6 faceSize² cells, faces in OpenGL's order, row by row: the probability that a draw of this cell stays with it;
  /// the cell it goes to otherwise; the densities of draws in this cell and in that other, per unit of the face's s and
  /// t, which run from -1 to 1.
  std::vector<glm::vec4> cells;
};

/// Reads level 0 of `radiance`. Cells have at least one texel; at most kLargestFace cells along a face.
LightTable makeLightTable(const CubeMap& radiance);

/// Makes its table at the first use, since few maps need one. Copies share the table; thread-safe.
class LazyLightTable {
 public:
  std::shared_ptr<const LightTable> of(const CubeMap& radiance) const {
    auto table = std::atomic_load(&table_);
    if (!table) {
      table = std::make_shared<const LightTable>(makeLightTable(radiance));
      std::atomic_store(&table_, table);
    }
    return table;
  }

 private:
  mutable std::shared_ptr<const LightTable> table_;
};

}  // namespace boxprobe
