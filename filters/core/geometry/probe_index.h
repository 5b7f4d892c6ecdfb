// Finds the probes of a scene that reach a box.
#pragma once

#include <cstddef>
#include <vector>

#include "filters/core/geometry/box_tree.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

class ProbeIndex {
 public:
  ProbeIndex() = default;
  explicit ProbeIndex(const std::vector<Probe>& probes);

  /// Ascending indices of the probes whose influenceBounds() meet an axis-aligned box.
  std::vector<std::size_t> meeting(const Box& boundsWorld) const;

 private:
  BoxTree tree_;
};

}  // namespace boxprobe
