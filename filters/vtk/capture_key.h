// What a capture depends on, as text: equal keys, equal pictures. Decides what is captured again after an edit, and
// finds maps made before (undo costs nothing).
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene.h"
#include "filters/vtk/model_actors.h"

namespace boxprobe {

/// The part all probes share: objects that probes see with their materials, lights, sky. `modelGeneration` stands for
/// the geometry and the models' own materials.
std::string sharedCaptureKey(const Scene& scene, const std::vector<DrawnObject>& objects, int modelGeneration);

/// The key of one probe. With more than one bounce a capture shows the captures of the other probes that any object
/// uses, so their inputs count too; boxes, blend distances and techniques never do: what they change inside of a
/// reflection's reflection is left as baked.
std::string captureKey(const Scene& scene, std::size_t probe, const std::vector<bool>& used, const std::string& shared);

/// The key of the sky's own map.
std::string skyKey(const Scene& scene);

}  // namespace boxprobe
