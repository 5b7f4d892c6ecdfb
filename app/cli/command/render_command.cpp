// See render_command.h.
#include "app/cli/command/render_command.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <cstdio>
#include <functional>
#include <memory>

#include "app/cli/command/reference_picture.h"
#include "app/cli/options/render_options.h"
#include "app/cli/report/view_sheet.h"
#include "app/session/display_check.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_window.h"
#include "app/session/output_check.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// Draws and writes the picture: nothing is written if the drawing failed or was interrupted. Of an animated technique,
/// the mean of --frames; those are told to `beforeFrame` as they begin.
void writePicture(SceneRenderer& renderer, const RenderOptions& options, bool linear, const InterruptGuard& interrupt,
                  const std::function<void()>& beforeFrame) {
  const bool picture = renderer.view().view == 0 && options.view != kAllViews;
  const bool mean = options.frames > 1 && picture && renderer.averagesFrames();
  const auto before = [&](int) {
    interrupt.check();
    beforeFrame();
  };
  if (linear) {
    const FrameSize size = parseFrameSize(options.size);
    const ImageRgbaF image =
        renderer.renderLinear(size.width, size.height, options.samples, mean ? options.frames : 1, before);
    requireHealthy(renderer);
    interrupt.check();
    saveExr(options.outputPath, image);
  } else {
    const bool sheet = options.view == kAllViews;
    // The last one is drawn by renderDisplay.
    if (mean) renderer.setFrameLimit(options.frames);
    for (int i = 0; mean && i < options.frames; ++i) {
      before(i);
      if (i + 1 < options.frames) renderer.renderer()->GetRenderWindow()->Render();
    }
    const ImageRgba8 image = sheet ? renderViewSheet(renderer, [&] { interrupt.check(); }) : renderer.renderDisplay();
    requireHealthy(renderer);
    interrupt.check();
    savePng(options.outputPath, image);
  }
}

/// CPU seconds of one frame of the kind that was asked for, the picture itself not written.
double timedFrame(SceneRenderer& renderer, vtkOpenGLRenderWindow* window, const RenderOptions& options, bool linear) {
  const double start = processCpuSeconds();
  if (linear) {
    const FrameSize size = parseFrameSize(options.size);
    renderer.renderLinear(size.width, size.height, options.samples);
  } else {
    window->Render();
    window->WaitForCompletion();  // software OpenGL works on in its threads after the call has returned
  }
  return processCpuSeconds() - start;
}

void runRender(const RenderOptions& options) {
  const bool linear = requireExtension("-o", options.outputPath, {".png", ".exr"}) == ".exr";
  const FrameSize size = parseFrameSize(options.size);
  if (linear && options.view == kAllViews) {
    throw InputError("-o " + options.outputPath + ": a sheet of all views is a .png; an .exr holds one view's numbers");
  }
  requireWritable("-o", options.outputPath);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);

  if (isReference(options.technique)) {
    renderReference(options, linear);
    return;
  }
  refuseReferenceOptions(options);
  const InterruptGuard interrupt;
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet);
  chooseTechnique(loaded.scene, options.technique);
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);  // of the technique that is used
  const Camera camera = chooseCamera(loaded.scene, options.camera);
  const SurfaceViewSettings view = parseView(options.view, options.range);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  interrupt.check();

  requireDisplay("boxprobe render");
  installVtkMessages(options.report.quiet, false);
  const vtkSmartPointer<vtkOpenGLRenderWindow> window = makeOffscreenWindow(size.width, size.height, options.samples);
  if (!linear && !options.report.quiet && options.samples > 1 && window->GetMultiSamples() < options.samples) {
    printWarnings({"--samples " + std::to_string(options.samples) + ": this OpenGL offers " +
                   std::to_string(window->GetMultiSamples()) + " samples a pixel, the picture is drawn with those"});
  }
  SceneRenderer renderer(window);
  renderer.setProbesEnabled(options.probes == "on");
  renderer.useBakedFiles(BakeFolder::besideScene(options.scenePath));
  renderer.setModels(loaded.models);
  renderer.sync(loaded.scene, Changes::all());
  renderer.applyCamera(camera);
  renderer.setView(view);
  captureProbes(renderer, interrupt, options.report.quiet);
  requireHealthy(renderer);
  interrupt.check();

  const double beforeFrame = processCpuSeconds();
  std::vector<double> begun;  // frames of a mean
  writePicture(renderer, options, linear, interrupt, [&] {
    window->WaitForCompletion();
    begun.push_back(processCpuSeconds());
  });
  const double written = processCpuSeconds();
  const double firstFrame = begun.size() > 1 ? begun[1] : written;

  std::vector<double> frames;
  if (begun.size() > 1) {
    for (std::size_t i = 0; i + 1 < begun.size(); ++i) frames.push_back(begun[i + 1] - begun[i]);
    frames.push_back(written - begun.back());
  } else {
    for (int i = 0; i < options.frames; ++i) {
      interrupt.check();
      frames.push_back(timedFrame(renderer, window, options, linear));
    }
  }
  // Without --frames the one frame there is is timed, the compilation of its programs included.
  if (frames.empty()) frames.push_back(firstFrame - beforeFrame);
  requireHealthy(renderer);

  RunStats stats = collectStats(renderer, window);
  stats.startToFirstFrameCpuSeconds = firstFrame;
  stats.modelLoadCpuSeconds = loaded.loadCpuSeconds;
  stats.frameCpuSeconds = frames;
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
  if (options.report.json) {
    std::fputs(statsJson(stats).c_str(), stdout);
  } else if (!options.report.quiet) {
    std::printf("%s: %d x %d, camera %s, %llu faces captured, %.1f s of CPU time\n", options.outputPath.c_str(),
                size.width, size.height, camera.name.c_str(),
                static_cast<unsigned long long>(stats.counters.facesCaptured), firstFrame);
  }
  renderer.releaseGraphics();
}

}  // namespace

Subcommand addRenderCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw a scene into a picture file, without a window");
  const auto options = std::make_shared<RenderOptions>();
  addRenderOptions(*command, *options);
  return {command, [options] { runRender(*options); }};
}

}  // namespace boxprobe
