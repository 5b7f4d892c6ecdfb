// Cuts objects that more probes reach than one draw can have into pieces that fewer reach: a floor of a hundred metres
// becomes several of ten, each drawn with its own probes. Pieces keep their object's name, so overrides, reports and
// captures still treat them as one object.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A model in which the instances that more than `most` of the scene's probes compete for are divided; the same pointer
/// if there are none. Division stops where it does not help: probes that overlap everywhere cannot be separated.
std::shared_ptr<const Model> dividedModel(std::shared_ptr<const Model> model, const glm::dmat4& worldFromModel,
                                          const std::vector<Probe>& probes, const ProbeIndex& index, std::size_t most);

/// The parts of a mesh on either side of the plane x_axis = `at`, in world axes. New vertices on the plane are
/// identical in both, so that no gap opens.
struct MeshHalves {
  Mesh below, above;
};
MeshHalves cutMesh(const Mesh& mesh, const glm::dmat4& worldFromModel, int axis, double at);

}  // namespace boxprobe
