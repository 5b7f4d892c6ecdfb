// Parts of a frame that can be disabled to measure their cost: frames with and without a part are timed in alternation.
// The resulting picture is wrong and never shown.
#pragma once

#include <string>

namespace boxprobe {

enum FramePart : unsigned {
  kReflectionPart = 1u,  ///< light of probes and sky: projection, lookups, harmonics, weights
  kLampsPart = 2u,       ///< the loop over lamps, including shadows by coverage
  kMaterialPart = 4u,    ///< textures and normal maps
  kOutputPart = 8u,      ///< the conversion to display colours
  kFragmentPart = 16u,   ///< all fragment work; the colour is constant
  kRasterPart = 32u,     ///< only vertices
  kObjectPart = 64u,     ///< not drawn
  kGroundPart = 128u,    ///< the ground's shadow
  kOpennessPart = 256u,  ///< what hides the sky from places of the scene itself
};
using FrameParts = unsigned;  ///< of FramePart

/// Removes the parts from a surface's fragment shader, which is spliced but still writes `gl_FragData` as VTK's own
/// text does.
void removeParts(std::string& fragment, FrameParts parts);

}  // namespace boxprobe
