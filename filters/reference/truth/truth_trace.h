// Both references at the floor of a truth picture, with positions and rays enough for it. Called by `bench --truth` and
// by tests; knows no GL.
#pragma once

#include "filters/reference/light/reference_box.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/truth/truth_index.h"

namespace boxprobe {

/// How finely the program draws what is compared with truth pictures: so many times their width and height, averaged
/// down. A technique's derivatives are then those of a picture of usual size, and a mirror has positions enough.
inline constexpr int kTruthFineness = 5;

struct TruthEffort {
  int rays = 512;  ///< per pixel of a rough floor; a mirror needs positions alone
  int stride = 1;  ///< of the floor's pixels, one in so many is made; the others have alpha 0
};

/// `reference`: of the scene with the picture's floor.
ReferencePicture traceTruth(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                            const Camera& camera, const TruthEffort& effort, const ReferenceProgress& progress = {});

/// The integral over the box of the scene's only probe, of which `maps` are: on the points that the tracer finds.
ReferencePicture integrateTruth(const ReferenceScene& reference, const Probe& probe, const ReferenceBoxMaps& maps,
                                const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                                const TruthEffort& effort, const ReferenceProgress& progress = {});

}  // namespace boxprobe
