#include "filters/vtk/probes/probe_memory.h"

#include <algorithm>

#include "filters/vtk/gl/map_bytes.h"

namespace boxprobe {

void MemoryNeed::add(const Probe& probe, const CustomPictures& pictures) {
  const bool custom = probe.mode == ProbeMode::Custom;
  const auto picture = custom ? pictures.picture(probe.name) : nullptr;
  const int size = picture ? picture->faceSize() : probe.faceSize;
  // A further bounce is captured while the one before it lights the scene.
  maps_ += probeMapsBytes(size, !custom) * (probe.bounces > 1 && !custom ? 2 : 1);
  scratch_ = std::max(scratch_, captureScratchBytes(size));
  largest_ = std::max(largest_, size);
  ++count_;
}

std::string MemoryNeed::error(std::size_t limitBytes) const {
  return "the maps of " + std::to_string(count_) + " probes with faces of up to " + std::to_string(largest_) +
         " texels need " + memoryText(bytes()) + " of texture memory, and there are " + memoryText(limitBytes) +
         " (BOXPROBE_TEXTURE_MEMORY, in MB, sets another limit); lower faceSize or bounces, or bake a share at a time "
         "(bake --shard)";
}

}  // namespace boxprobe
