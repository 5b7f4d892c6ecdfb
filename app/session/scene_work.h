// What every sub-command that draws does between loading a scene and using it. Called by render, explain and bake.
#pragma once

#include <string>
#include <vector>

#include "app/session/load_scene.h"

namespace boxprobe {

class InterruptGuard;
class SceneRenderer;

/// A picture without its reflections, or with a mesh missing, must not pass for the real one: throws WorkError.
void requireHealthy(const SceneRenderer& renderer);

/// Captures and filters what the scene needs, with a progress line; stops early when interrupted. Throws InputError for
/// a custom probe whose picture cannot be read.
void captureProbes(SceneRenderer& renderer, const InterruptGuard& interrupt, bool quiet);

/// loadScene() with its progress on stderr; Ctrl-C ends it with a WorkError.
LoadedScene loadSceneShown(const std::string& path, const std::vector<std::string>& assignments,
                           const InterruptGuard& interrupt, bool quiet);

}  // namespace boxprobe
