// What a probe shows while nothing of it is captured: its surroundings as the sky's light alone, blurred, so that
// metals reflect something from the first frame on. Shown only; captures see none of it.
#pragma once

#include <memory>

#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// `image`: that of a sky that is one, else null. A sky too dark to be seen at the scene's exposure is an even grey.
/// Where the sky shows through a probe's openings ("clear": "open") nothing covers it.
BakedMaps standInMaps(const Scene& scene, const ImageRgbaF* image, const Probe& probe);

}  // namespace boxprobe
