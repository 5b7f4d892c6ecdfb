// See automatic_exposure.h.
#include "app/session/automatic_exposure.h"

#include <algorithm>
#include <cmath>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/fit/exposure_key.h"

namespace boxprobe {

double measuredExposure(SceneRenderer& renderer, bool skyToo, double aspect, Tone tone) {
  constexpr int kHeight = 72;
  const int width = std::clamp(static_cast<int>(std::lround(kHeight * aspect)), 16, 4 * kHeight);
  return keyedExposure(renderer.renderLinear(width, kHeight, 1), skyToo, tone);
}

void exposeAutomatically(OffscreenScene& shown, LoadedScene& loaded, const ShownSettings& settings, double aspect) {
  if (!loaded.exposureAutomatic) return;
  loaded.scene.exposure = measuredExposure(shown.renderer(), loaded.fit->within, aspect, loaded.scene.tone);
  loaded.exposureAutomatic = false;
  shown.show(loaded.scene, loaded.models, settings);
}

}  // namespace boxprobe
