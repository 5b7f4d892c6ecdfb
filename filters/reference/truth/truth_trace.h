// The scene reference at the size of a truth picture: rays enough for its floor. Called by `bench --truth` and by
// tests.
#pragma once

#include "filters/reference/light/reference_box.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/reference/truth/truth_index.h"

namespace boxprobe {

/// How finely the program draws what is compared with truth pictures: so many times their width and height, averaged
/// down. A technique's derivatives are then those of a picture of usual size, and a mirror has positions enough.
inline constexpr int kTruthFineness = 5;

/// `reference`: of the scene with the picture's floor. `rays` per pixel where the floor is rough; a mirror needs
/// positions alone.
ReferencePicture traceTruth(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                            const Camera& camera, int rays, const ReferenceProgress& progress = {});

/// The integral over the box of the scene's only probe, of which `maps` are: on the points that the tracer finds.
ReferencePicture integrateTruth(const ReferenceScene& reference, const Probe& probe, const ReferenceBoxMaps& maps,
                                const TruthIndex& index, const TruthPicture& picture, const Camera& camera, int rays,
                                const ReferenceProgress& progress = {});

/// Where a floor is so smooth that one ray a position tells all.
bool isMirror(const TruthPicture& picture);

}  // namespace boxprobe
