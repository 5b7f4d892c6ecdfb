// The whole picture as the probes' boxes have it, integrated (see filters/reference/light/reference_box.h): what is
// left of a technique's error against it is the technique's own. Called by `render --technique reference-box` and by
// lessons.
#pragma once

#include "filters/core/scene/scene.h"
#include "filters/reference/light/progressive_picture.h"
#include "filters/reference/light/reference_box.h"

namespace boxprobe {

class SceneRenderer;

struct BoxPictureSize {
  int width = 1280, height = 720;
  int samplesPerPixel = 4;  ///< 1, 4 or 16
  int raysPerPixel = 256;   ///< over all of them
  PicturePart part;         ///< what of the picture is wanted; the rest stays black
};

/// What the probes and the sky show now.
ReferenceBoxMaps boxMaps(SceneRenderer& renderer, const Scene& scene);

/// Through the renderer's current camera. `progress` may stop it.
ReferencePicture integrateBox(SceneRenderer& renderer, const ReferenceBoxMaps& maps, const BoxPictureSize& size,
                              const ReferenceProgress& progress = {});

}  // namespace boxprobe
