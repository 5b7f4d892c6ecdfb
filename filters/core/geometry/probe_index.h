// The probes of a scene found by place: which of them reach a box. Built once for a state of the scene; asked for every
// object that is drawn and every one that is captured.
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

  /// Indices, ascending, of those whose influenceBounds() meet an axis-aligned box.
  std::vector<std::size_t> meeting(const Box& boundsWorld) const;

 private:
  BoxTree tree_;
};

}  // namespace boxprobe
