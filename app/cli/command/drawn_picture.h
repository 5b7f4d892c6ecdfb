// The picture that `render` draws: written to its file, and timed. Called by render_command once the scene is shown and
// its captures are made; knows neither scene files nor captures.
#pragma once

#include <vector>

#include "app/cli/options/render_options.h"

namespace boxprobe {

class InterruptGuard;
class OffscreenScene;

struct PictureTimes {
  double firstFrame = 0.0;  ///< CPU seconds of the process when the first frame was drawn and, if alone, written
  std::vector<double> frameSeconds;  ///< CPU seconds of each frame; of the first one alone where none were asked for
};

/// Draws and writes the picture, a PNG or (`linear`) an EXR file, then times --frames. Of an animated technique the
/// picture is the mean of --frames, and those are timed. Nothing is written if the drawing failed or was interrupted:
/// throws WorkError.
PictureTimes drawPicture(OffscreenScene& shown, const RenderOptions& options, bool linear,
                         const InterruptGuard& interrupt);

}  // namespace boxprobe
