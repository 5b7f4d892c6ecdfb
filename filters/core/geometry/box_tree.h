// A bounding volume hierarchy over axis-aligned boxes: finding which of a thousand probes or objects meet something
// takes time that depends on what is near.
#pragma once

#include <cstddef>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class BoxTree {
 public:
  struct Node {
    Box bounds;
    int left = -1, right = -1;  ///< -1: a leaf, which holds items()[first .. first + count)
    int first = 0, count = 0;
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  bool empty() const { return nodes_.empty(); }
  /// The root is the first node.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Indices into the boxes the tree was built from; those of a node are contiguous.
  const std::vector<std::size_t>& items() const { return items_; }
  const Box& box(std::size_t index) const { return boxes_[index]; }

  /// Calls visit(index) for each box for which `meets(box)` is true, in no particular order. `meets` must be true for
  /// every box that contains one for which it is true.
  template <typename Meets, typename Visit>
  void search(const Meets& meets, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::vector<int> open = {0};
    while (!open.empty()) {
      const Node& node = nodes_[static_cast<std::size_t>(open.back())];
      open.pop_back();
      if (!meets(node.bounds)) continue;
      if (node.left >= 0) {
        open.push_back(node.left);
        open.push_back(node.right);
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        const std::size_t item = items_[static_cast<std::size_t>(i)];
        if (meets(boxes_[item])) visit(item);
      }
    }
  }

 private:
  int build(int first, int count);

  std::vector<Box> boxes_;
  std::vector<std::size_t> items_;
  std::vector<Node> nodes_;
};

/// Do two boxes meet? Touching counts.
inline bool boxesMeet(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && a.max.x >= b.min.x && a.min.y <= b.max.y && a.max.y >= b.min.y && a.min.z <= b.max.z &&
         a.max.z >= b.min.z;
}

}  // namespace boxprobe
