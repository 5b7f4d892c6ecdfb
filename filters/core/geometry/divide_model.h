// Cuts objects that more probes reach than one draw can have into pieces that fewer reach: a floor of a hundred metres
// becomes some of ten, each drawn with its own probes. Called by the scene renderer when boxes have come to rest. The
// pieces keep their object's name, so that overrides, reports and captures see one object still.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A model with the instances divided that more than `most` of the scene's probes compete for; the same pointer if
/// there are none. Division ends where it does not help: probes that overlap everywhere cannot be kept apart.
std::shared_ptr<const Model> dividedModel(std::shared_ptr<const Model> model, const glm::dmat4& worldFromModel,
                                          const std::vector<Probe>& probes, const ProbeIndex& index, std::size_t most);

/// What of a mesh lies on either side of the plane x_axis = `at`, axes of the world it is placed in. New vertices on
/// the plane are the same in both, so that no gap opens.
struct MeshHalves {
  Mesh below, above;
};
MeshHalves cutMesh(const Mesh& mesh, const glm::dmat4& worldFromModel, int axis, double at);

}  // namespace boxprobe
