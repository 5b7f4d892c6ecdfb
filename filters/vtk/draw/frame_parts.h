// Parts of a frame that can be left out, to find what each of them costs: a frame without a part is timed in turn with
// one that has it. The picture of such a frame is wrong, and nobody's to see. Text and numbers; knows neither OpenGL
// nor VTK's classes.
#pragma once

#include <string>

namespace boxprobe {

enum FramePart : unsigned {
  kReflectionPart = 1u,  ///< light of probes and sky: projection, lookups, harmonics, weights
  kLampsPart = 2u,       ///< the lamps' loop, shadows by coverage included
  kMaterialPart = 4u,    ///< textures and normal maps
  kOutputPart = 8u,      ///< the conversion to display colours
  kFragmentPart = 16u,   ///< all that is worked out for a pixel; it is one colour
  kRasterPart = 32u,     ///< nothing but vertices
  kObjectPart = 64u,     ///< not drawn at all
  kGroundPart = 128u,    ///< the ground's shadow
  kOpennessPart = 256u,  ///< what hides the sky from places of the scene itself
};
using FrameParts = unsigned;  ///< of FramePart

/// Takes the parts out of a surface's fragment shader, spliced but with `gl_FragData` still as VTK's own text has it.
void leaveOut(std::string& fragment, FrameParts parts);

}  // namespace boxprobe
