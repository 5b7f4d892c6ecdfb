// See scene_work.h.
#include "app/session/scene_work.h"

#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/progress_line.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

void requireHealthy(const SceneRenderer& renderer) {
  if (!renderer.error().empty()) throw WorkError(renderer.error());
  if (!firstVtkError().empty()) throw WorkError(firstVtkError());
}

void captureProbes(SceneRenderer& renderer, const InterruptGuard& interrupt, bool quiet) {
  if (!renderer.pictureError().empty()) throw InputError(renderer.pictureError());
  ProgressLine line("capturing probes", !quiet);
  renderer.finishWork([&](double fraction) {
    line.show(fraction);
    return !interrupt.interrupted();
  });
  if (!quiet) printWarnings(renderer.remarks());
}

LoadedScene loadSceneShown(const std::string& path, const std::vector<std::string>& assignments,
                           const InterruptGuard& interrupt, bool quiet) {
  ProgressLine line("loading", !quiet);
  return loadScene(path, assignments, [&](double fraction) {
    line.show(fraction);
    interrupt.check();
    return true;
  });
}

}  // namespace boxprobe
