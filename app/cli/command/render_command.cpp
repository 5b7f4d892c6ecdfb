// See render_command.h.
#include "app/cli/command/render_command.h"

#include <cstdio>
#include <memory>

#include "app/cli/command/drawn_picture.h"
#include "app/cli/command/reference_picture.h"
#include "app/cli/command/short_run.h"
#include "app/cli/options/render_options.h"
#include "app/session/automatic_exposure.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/output_check.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/files/atomic_file.h"

namespace boxprobe {

namespace {

/// A driver may offer fewer samples than were asked for; renderLinear() takes its own.
void warnOfSamples(const OffscreenScene& shown, int wanted) {
  const int offered = shown.window()->GetMultiSamples();
  if (wanted <= 1 || offered >= wanted) return;
  printWarnings({"--samples " + std::to_string(wanted) + ": this OpenGL offers " + std::to_string(offered) +
                 " samples per pixel; the picture is drawn with that many"});
}

void runRender(const RenderOptions& options) {
  useLargePages();
  const bool linear = requireExtension("-o", options.outputPath, {".png", ".exr"}) == ".exr";
  const FrameSize size = parseFrameSize(options.size);
  if (linear && options.view == kAllViews) {
    throw InputError("-o " + options.outputPath +
                     ": a sheet of all views must be a .png; an .exr holds the numbers of one view");
  }
  requireWritable("-o", options.outputPath);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);

  if (isReference(options.technique)) {
    renderReference(options, linear);
    return;
  }
  refuseReferenceOptions(options);
  const InterruptGuard interrupt;
  const double aspect = static_cast<double>(size.width) / size.height;
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet,
                                      parseFitWishes(options.fit, aspect));
  chooseTechnique(loaded.scene, options.technique);
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);  // of the technique that is used
  const Camera camera = chooseCamera(loaded.scene, options.camera);
  const SurfaceViewSettings view = parseView(options.view, options.range);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  interrupt.check();

  const auto kept = std::make_shared<OffscreenScene>(
      OffscreenSettings{"boxprobe render", size.width, size.height, options.samples, options.report.quiet, false,
                        options.report.offscreen, drawsLittle(options.frames, loaded.scene.probes.size())});
  keepToTheEnd(kept);
  OffscreenScene& shown = *kept;
  if (!linear && !options.report.quiet) warnOfSamples(shown, options.samples);
  const ShownSettings settings{camera, options.probes == "on", BakeFolder::besideScene(options.scenePath), {}, view};
  shown.show(loaded.scene, loaded.models, settings);
  captureShown(shown, interrupt, options.report.quiet);
  if (!linear) exposeAutomatically(shown, loaded, settings, aspect);
  const PictureTimes times = drawPicture(shown, options, linear, interrupt);

  RunStats stats = collectStats(shown.renderer(), shown.window());
  stats.startToFirstFrameCpuSeconds = times.firstFrame;
  stats.modelLoadCpuSeconds = loaded.loadCpuSeconds;
  stats.frameCpuSeconds = times.frameSeconds;
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
  if (options.report.json) {
    printDocument(statsJson(stats));
  } else if (!options.report.quiet) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.1f", times.firstFrame);
    printResult(options.outputPath + ": " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                ", camera " + camera.name + ", " + std::to_string(stats.counters.facesCaptured) + " faces captured, " +
                seconds + " s of CPU time\n");
  }
}

}  // namespace

Subcommand addRenderCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Render a scene to a picture file without a window");
  const auto options = std::make_shared<RenderOptions>();
  addRenderOptions(*command, *options);
  return {command, [options] {
            if (!options->tone.empty()) options->assignments.push_back("tone=" + options->tone);
            runRender(*options);
          }};
}

}  // namespace boxprobe
