// Renders both references on the floor of an independent picture, with enough positions and rays for the comparison.
#pragma once

#include "filters/reference/light/reference_box.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/truth/truth_index.h"

namespace boxprobe {

/// Pictures are drawn at this multiple of the size and averaged down, so that a technique's derivatives are those of a
/// picture of usual size, and a mirror has enough positions.
inline constexpr int kTruthFineness = 5;

struct TruthEffort {
  int rays = 512;  ///< per pixel of a rough floor; a mirror needs only positions
  int stride = 1;  ///< renders one of this many floor pixels; the others have alpha 0
};

/// `reference`: of the scene with the picture's floor.
ReferencePicture traceTruth(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                            const Camera& camera, const TruthEffort& effort, const ReferenceProgress& progress = {});

/// The integral over the box of the scene's only probe, from its `maps`, at the points that the tracer finds.
ReferencePicture integrateTruth(const ReferenceScene& reference, const Probe& probe, const ReferenceBoxMaps& maps,
                                const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                                const TruthEffort& effort, const ReferenceProgress& progress = {});

}  // namespace boxprobe
