// Work on a scene that its user waits for: progress on stderr, stopped by Ctrl-C. Called by the sub-commands.
#pragma once

#include <string>
#include <vector>

#include "app/session/load_scene.h"

namespace boxprobe {

class InterruptGuard;
class OffscreenScene;

/// loadScene() with its progress and what was decided of a bare model on stderr; Ctrl-C ends it with a WorkError.
LoadedScene loadSceneShown(const std::string& path, const std::vector<std::string>& assignments,
                           const InterruptGuard& interrupt, bool quiet, const FitWishes& wishes = {});

/// Captures and filters what is missing, with its progress and the renderer's remarks on stderr, so that the picture
/// can be drawn. Throws WorkError if it was interrupted or something could not be made.
void captureShown(OffscreenScene& scene, const InterruptGuard& interrupt, bool quiet);

}  // namespace boxprobe
