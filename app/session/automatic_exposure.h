// The exposure of a bare model, found from a small picture of it. Called by what draws one.
#pragma once

namespace boxprobe {

class OffscreenScene;
class SceneRenderer;
struct LoadedScene;
struct ModelFit;
struct ShownSettings;

/// The exposure that the picture asks for through the renderer's camera, captures done; `aspect` is its width over its
/// height. Draws a frame of some thousand pixels.
double measuredExposure(SceneRenderer& renderer, const ModelFit& fit, double aspect);

/// Puts it into the scene where that is automatic, and shows it.
void exposeAutomatically(OffscreenScene& shown, LoadedScene& loaded, const ShownSettings& settings, double aspect);

}  // namespace boxprobe
