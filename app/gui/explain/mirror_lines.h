// Planar mirrors made visible: the mirrored eye of each, the edges of what it sees through its mirror, and, of an
// explained pixel, the reflected ray up to what moves. Called by the debug view; knows no panel.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/explain/explanation.h"
#include "filters/vtk/widgets/wire_actors.h"

namespace boxprobe {

class MirrorLines {
 public:
  explicit MirrorLines(vtkRenderer* renderer);

  void setModels(std::vector<std::shared_ptr<const Model>> models) { models_ = std::move(models); }
  void setShown(bool shown);
  bool shown() const { return shown_; }
  /// Null: none.
  void explain(const Explanation* explanation);
  /// Before each picture. `eyeWorld`, `forwardWorld` as `parallel` says: where it is seen from. `drawn`: the mirrors
  /// that have a picture.
  void update(const Scene& scene, const std::vector<std::string>& drawn, const glm::dvec3& eyeWorld,
              const glm::dvec3& forwardWorld, bool parallel);
  /// Lines shown, for tests.
  std::size_t lines() const { return lines_; }

 private:
  HaloLines portals_, rays_;
  std::vector<std::shared_ptr<const Model>> models_;
  bool shown_ = false;
  std::vector<glm::dvec3> ray_;
  std::size_t lines_ = 0;
};

}  // namespace boxprobe
