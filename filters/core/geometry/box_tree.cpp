#include "filters/core/geometry/box_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>

namespace boxprobe {

namespace {

constexpr int kLeaf = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) : boxes_(boxes), items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), std::size_t{0});
  if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
}

// Splits at the median along the longest side of the centres: boxes that fill space like rooms need no cost heuristic.
int BoxTree::build(int first, int count) {
  const int at = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  const auto begin = items_.begin() + first, end = begin + count;
  Box bounds = boxes_[*begin], middles{bounds.center(), bounds.center()};
  for (auto it = begin; it != end; ++it) {
    const Box& box = boxes_[*it];
    bounds = Box{glm::min(bounds.min, box.min), glm::max(bounds.max, box.max)};
    middles = Box{glm::min(middles.min, box.center()), glm::max(middles.max, box.center())};
  }
  Node node;
  node.bounds = bounds;
  node.first = first;
  node.count = count;
  if (count > kLeaf) {
    const glm::dvec3 size = middles.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::nth_element(begin, begin + count / 2, end, [&](std::size_t a, std::size_t b) {
      const double x = boxes_[a].center()[axis], y = boxes_[b].center()[axis];
      return x != y ? x < y : a < b;
    });
    node.left = build(first, count / 2);
    node.right = build(first + count / 2, count - count / 2);
  }
  nodes_[static_cast<std::size_t>(at)] = node;
  return at;
}

}  // namespace boxprobe
