// See drawn_picture.h.
#include "app/cli/command/drawn_picture.h"

#include <functional>

#include "app/cli/report/view_sheet.h"
#include "app/session/interrupt.h"
#include "app/session/offscreen_scene.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

namespace {

/// `beforeFrame` is told of the frames of a mean as they begin.
void writePicture(OffscreenScene& shown, const RenderOptions& options, bool linear, const InterruptGuard& interrupt,
                  const std::function<void()>& beforeFrame) {
  SceneRenderer& renderer = shown.renderer();
  const bool picture = renderer.view().view == 0 && options.view != kAllViews;
  const bool mean = options.frames > 1 && picture && renderer.averagesFrames();
  const auto before = [&](int) {
    interrupt.check();
    beforeFrame();
  };
  const RefineSettings refine = renderer.refineSettings();
  if (linear) {
    const FrameSize size = parseFrameSize(options.size);
    const ImageRgbaF image =
        refine.rays > 0
            ? renderer.renderRefined(size.width, size.height, options.samples, refine, before)
            : renderer.renderLinear(size.width, size.height, options.samples, mean ? options.frames : 1, before);
    shown.requireHealthy();
    interrupt.check();
    saveExr(options.outputPath, image);
  } else {
    const bool sheet = options.view == kAllViews;
    // The last one is drawn by renderDisplay.
    if (mean) renderer.setFrameLimit(options.frames);
    for (int i = 0; mean && i < options.frames; ++i) {
      before(i);
      if (i + 1 < options.frames) shown.window()->Render();
    }
    if (refine.rays > 0) {
      // The last one is drawn by renderDisplay, too: it finds nothing left to add.
      do {
        interrupt.check();
        shown.window()->Render();
      } while (renderer.frameCount().more());
    }
    const ImageRgba8 image = sheet ? renderViewSheet(renderer, [&] { interrupt.check(); }) : renderer.renderDisplay();
    shown.requireHealthy();
    interrupt.check();
    savePng(options.outputPath, image);
  }
}

/// CPU seconds of one frame of the kind that was asked for, the picture itself not written.
double timedFrame(OffscreenScene& shown, const RenderOptions& options, bool linear) {
  if (!linear) return shown.timedFrame();
  const double start = processCpuSeconds();
  const FrameSize size = parseFrameSize(options.size);
  shown.renderer().renderLinear(size.width, size.height, options.samples);
  return processCpuSeconds() - start;
}

}  // namespace

PictureTimes drawPicture(OffscreenScene& shown, const RenderOptions& options, bool linear,
                         const InterruptGuard& interrupt) {
  const double beforeFrame = processCpuSeconds();
  std::vector<double> begun;  // frames of a mean
  writePicture(shown, options, linear, interrupt, [&] {
    shown.window()->WaitForCompletion();
    begun.push_back(processCpuSeconds());
  });
  const double written = processCpuSeconds();

  PictureTimes times;
  times.firstFrame = begun.size() > 1 ? begun[1] : written;
  if (begun.size() > 1) {
    for (std::size_t i = 0; i + 1 < begun.size(); ++i) times.frameSeconds.push_back(begun[i + 1] - begun[i]);
    times.frameSeconds.push_back(written - begun.back());
  } else {
    for (int i = 0; i < options.frames; ++i) {
      interrupt.check();
      times.frameSeconds.push_back(timedFrame(shown, options, linear));
    }
  }
  // Without --frames the one frame there is is timed, the compilation of its programs included.
  if (times.frameSeconds.empty()) times.frameSeconds.push_back(times.firstFrame - beforeFrame);
  shown.requireHealthy();
  return times;
}

}  // namespace boxprobe
