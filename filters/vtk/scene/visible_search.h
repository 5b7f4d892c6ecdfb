// Finds the visible ones among many objects: draws a few at a time, nearest first, with occlusion queries of the
// branches of a bounding volume hierarchy in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "filters/core/geometry/box_tree.h"
#include "filters/vtk/gl/occlusion_query.h"
#include "filters/vtk/scene/view_frustum.h"

class vtkRenderer;

namespace boxprobe {

class VisibleSearch {
 public:
  /// For the renderer's current view. `asked` counts queried boxes.
  VisibleSearch(vtkRenderer* renderer, const BoxTree& tree, OcclusionQuery& test, std::uint64_t& asked);

  /// Ascending indices of items in view, including hidden ones.
  std::vector<std::size_t> inView() const;
  /// Draws all visible items, and few others, by `draw`. Returns those that are visible. `before`: the result for the
  /// previous view, which is mostly the same.
  std::vector<std::size_t> run(const std::vector<std::size_t>& before,
                               const std::function<void(const std::vector<std::size_t>&)>& draw);

 private:
  std::vector<bool> visible(const std::vector<Box>& boxes);
  std::vector<std::size_t> showing(const std::vector<std::size_t>& items);
  std::vector<std::size_t> unhidden(const std::vector<char>& drawn);
  void nearestFirst(std::vector<std::size_t>& items) const;

  vtkRenderer* renderer_;
  const BoxTree& tree_;
  OcclusionQuery& test_;
  std::uint64_t& asked_;
  ViewFrustum frustum_;
};

}  // namespace boxprobe
