// The exposure that suits a scene, found from a small picture of it. Called for bare models, and where the user asks.
#pragma once

#include "filters/math/shared/display_math.h"

namespace boxprobe {

class OffscreenScene;
class SceneRenderer;
struct LoadedScene;
struct ShownSettings;

/// The exposure that the picture asks for through the renderer's camera, captures done; `skyToo` counts the sky that is
/// seen; `aspect` is its width over its height. Draws a frame of some thousand pixels.
double measuredExposure(SceneRenderer& renderer, bool skyToo, double aspect, Tone tone);

/// Puts it into the scene where that is automatic, and shows it.
void exposeAutomatically(OffscreenScene& shown, LoadedScene& loaded, const ShownSettings& settings, double aspect);

}  // namespace boxprobe
