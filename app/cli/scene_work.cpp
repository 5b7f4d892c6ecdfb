// See scene_work.h.
#include "app/cli/scene_work.h"

#include "app/cli/interrupt.h"
#include "app/cli/messages.h"
#include "app/cli/progress_line.h"
#include "app/cli/vtk_messages.h"
#include "filters/core/errors.h"
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
