// See scene_work.h.
#include "app/session/scene_work.h"

#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/progress_line.h"

namespace boxprobe {

LoadedScene loadSceneShown(const std::string& path, const std::vector<std::string>& assignments,
                           const InterruptGuard& interrupt, bool quiet, const FitWishes& wishes) {
  LoadedScene loaded;
  {
    ProgressLine line("loading", !quiet);  // wiped before anything else is printed
    loaded = loadScene(
        path, assignments,
        [&](double fraction) {
          line.show(fraction);
          interrupt.check();
          return true;
        },
        wishes);
  }
  if (loaded.fit && !quiet) printNote(path + ": " + loaded.fit->decided.english());
  return loaded;
}

void captureShown(OffscreenScene& scene, const InterruptGuard& interrupt, bool quiet) {
  {
    ProgressLine line("capturing probes", !quiet);  // wiped before anything else is printed
    scene.capture([&](double fraction) {
      line.show(fraction);
      return !interrupt.interrupted();
    });
  }
  if (!quiet) printWarnings(scene.renderer().remarks());
  scene.requireHealthy();
  interrupt.check();
}

}  // namespace boxprobe
