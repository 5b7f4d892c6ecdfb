// Where a probe's light comes from, to draw directions by: its level 0 in cells of equal size on the faces, each as
// likely as it is bright, and an alias table (Walker 1977, Vose 1991), by which drawing one takes one lookup however
// many there are. Called by techniques through shaders/shared/light_sampling.glsl, on the CPU and, as a texture, on the
// GPU.
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
  /// 6 faceSize² cells, faces in OpenGL's order, row by row: the share of draws of this cell that stay with it, the
  /// cell that the others go to, the density of draws in this cell, and in that other: per unit of the face's s and t,
  /// which run from -1 to 1.
  std::vector<glm::vec4> cells;
};

/// `radiance`: level 0 is read. Cells of at least one texel, at most kLargestFace along a face.
LightTable makeLightTable(const CubeMap& radiance);

/// A table of a map that may never be asked for one. Copies share what has been made; safe from several threads.
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
