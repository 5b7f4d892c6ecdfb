// Which of many objects a view sees: drawn a few at a time, nearest first, with occlusion queries of the branches of a
// tree of their bounds in between. Called by the culled renderer, which draws; knows not what the objects are.
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
  /// Of the renderer's view as it is. `asked` counts boxes.
  VisibleSearch(vtkRenderer* renderer, const BoxTree& tree, OcclusionQuery& test, std::uint64_t& asked);

  /// Items in the view, hidden ones included, ascending.
  std::vector<std::size_t> inView() const;
  /// Draws all items that can be seen, and few others, by `draw`. Returns those that show past what was drawn.
  /// `before`: what the last view showed, which is most of what this one shows.
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
