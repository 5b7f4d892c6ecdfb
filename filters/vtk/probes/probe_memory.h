// How much texture memory the maps of probes will take together, known before any is made. Called by the plan; knows
// sizes and counts, neither OpenGL nor VTK.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/vtk/probes/custom_pictures.h"

namespace boxprobe {

/// What all probes in use will hold in the end, those that are there already included, and what making them needs.
class MemoryNeed {
 public:
  void add(const Probe& probe, const CustomPictures& pictures);
  std::size_t bytes() const { return maps_ + scratch_; }
  /// One line that says what does not fit into so many bytes, and what to lower.
  std::string error(std::size_t limitBytes) const;

 private:
  std::size_t maps_ = 0, scratch_ = 0, count_ = 0;
  int largest_ = 0;  ///< face size, texels
};

}  // namespace boxprobe
