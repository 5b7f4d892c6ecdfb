#include "filters/vtk/scene/object_memory.h"

#include <cstdint>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/platform/process.h"

namespace boxprobe {

void requireMemoryForObjects(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models) {
  constexpr std::uint64_t kBytes = 40000;  // of VTK's actor, property and mapper, and of ours
  const std::uint64_t memory = physicalMemoryBytes();
  std::uint64_t count = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    count += models[i]->instances.size();
    if (models[i]->instances.size() > models[most]->instances.size()) most = i;
  }
  if (memory == 0 || kBytes * count <= memory / 2) return;
  throw InputError(scene.models[most].file + ": places meshes " + std::to_string(models[most]->instances.size()) +
                   " times; drawing " + std::to_string(count) + " objects would take " + gigabytesText(kBytes * count) +
                   ", more than half of this machine's memory, so join some meshes");
}

}  // namespace boxprobe
