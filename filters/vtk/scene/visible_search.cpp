#include "filters/vtk/scene/visible_search.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace boxprobe {

VisibleSearch::VisibleSearch(vtkRenderer* renderer, const BoxTree& tree, OcclusionQuery& test, std::uint64_t& asked)
    : renderer_(renderer),
      tree_(tree),
      test_(test),
      asked_(asked),
      frustum_(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio()) {}

std::vector<std::size_t> VisibleSearch::inView() const {
  std::vector<std::size_t> items;
  tree_.search([&](const Box& box) { return frustum_.meets(box); }, [&](std::size_t item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<bool> VisibleSearch::visible(const std::vector<Box>& boxes) {
  asked_ += boxes.size();
  return test_.visible(renderer_, boxes);
}

std::vector<std::size_t> VisibleSearch::showing(const std::vector<std::size_t>& items) {
  std::vector<Box> boxes;
  boxes.reserve(items.size());
  for (const std::size_t item : items) boxes.push_back(tree_.box(item));
  const std::vector<bool> seen = visible(boxes);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (seen[i]) shown.push_back(items[i]);
  }
  return shown;
}

// Objects in view that are not drawn yet and not hidden by what has been drawn: queries branches of the tree level by
// level, a whole level at once.
std::vector<std::size_t> VisibleSearch::unhidden(const std::vector<char>& drawn) {
  std::vector<std::size_t> found;
  std::vector<int> open = {0};
  while (!open.empty()) {
    std::vector<int> inView;
    std::vector<Box> boxes;
    for (const int index : open) {
      const auto& node = tree_.nodes()[static_cast<std::size_t>(index)];
      if (!frustum_.meets(node.bounds)) continue;
      inView.push_back(index);
      boxes.push_back(node.bounds);
    }
    const std::vector<bool> seen = visible(boxes);
    open.clear();
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < inView.size(); ++i) {
      if (!seen[i]) continue;
      const auto& node = tree_.nodes()[static_cast<std::size_t>(inView[i])];
      if (node.left >= 0) {
        open.push_back(node.left);
        open.push_back(node.right);
        continue;
      }
      for (int k = node.first; k < node.first + node.count; ++k) {
        const std::size_t item = tree_.items()[static_cast<std::size_t>(k)];
        if (drawn[item] == 0 && frustum_.meets(tree_.box(item))) items.push_back(item);
      }
    }
    const std::vector<std::size_t> shown = showing(items);
    found.insert(found.end(), shown.begin(), shown.end());
  }
  return found;
}

void VisibleSearch::nearestFirst(std::vector<std::size_t>& items) const {
  glm::dvec3 eye;
  renderer_->GetActiveCamera()->GetPosition(&eye.x);
  const auto distance = [&](std::size_t item) {
    const Box& box = tree_.box(item);
    const glm::dvec3 away = glm::max(glm::max(box.min - eye, eye - box.max), glm::dvec3(0.0));
    return glm::dot(away, away);
  };
  std::stable_sort(items.begin(), items.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
}

std::vector<std::size_t> VisibleSearch::run(const std::vector<std::size_t>& before,
                                            const std::function<void(const std::vector<std::size_t>&)>& draw) {
  std::vector<char> drawn(tree_.items().size(), 0);
  std::vector<std::size_t> batch, all;
  for (const std::size_t item : before) {
    if (frustum_.meets(tree_.box(item))) batch.push_back(item);
  }
  std::size_t most = 16;  // nearest first, few at a time, because near objects hide most; later more, so that it ends
  if (batch.empty()) {
    batch = inView();
    nearestFirst(batch);
    batch.resize(std::min(batch.size(), most));
  }
  while (!batch.empty()) {
    for (const std::size_t item : batch) drawn[item] = 1;
    draw(batch);
    all.insert(all.end(), batch.begin(), batch.end());
    batch = unhidden(drawn);
    nearestFirst(batch);
    batch.resize(std::min(batch.size(), most));
    most *= 2;
  }
  // Drawn before what hides it: culled next time.
  return showing(all);
}

}  // namespace boxprobe
