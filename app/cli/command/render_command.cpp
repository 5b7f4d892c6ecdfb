// See render_command.h.
#include "app/cli/command/render_command.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command/drawn_picture.h"
#include "app/cli/command/reference_picture.h"
#include "app/cli/command/short_run.h"
#include "app/cli/options/render_options.h"
#include "app/session/automatic_exposure.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/opened_glb.h"
#include "app/session/output_check.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/platform/heap.h"

namespace boxprobe {

namespace {

/// A driver may offer fewer samples than were asked for; renderLinear() takes its own.
void warnOfSamples(const OffscreenScene& shown, int wanted) {
  const int offered = shown.window()->GetMultiSamples();
  if (wanted <= 1 || offered >= wanted) return;
  printWarnings({"--samples " + std::to_string(wanted) + ": this OpenGL offers " + std::to_string(offered) +
                 " samples per pixel; the picture is drawn with that many"});
}

void refuseBesideRefine(const RenderOptions& options) {
  const auto refuse = [](const std::string& option, const char* why) {
    throw InputError("--refine beside " + option + ": " + why);
  };
  if (!options.view.empty()) refuse("--view " + options.view, "a debug view shows numbers, which rays do not change");
  if (options.frames > 0) refuse("--frames", "the picture has as many frames as its rays take");
  if (options.probes != "on") refuse("--probes off", "there are no reflections to refine");
}

/// What rests is refined; what never does is told.
void warnOfUnrest(const Scene& scene) {
  for (const Probe& probe : scene.probes) {
    if (probe.mode != ProbeMode::Realtime) continue;
    printWarnings({"--refine: probe " + probe.name +
                   " is realtime, so that a window never rests; the picture is refined with what it shows now"});
    return;
  }
}

std::string percentText(double relative) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * relative);
  return text;
}

/// What became of --refine, for the summary. Warns of a percentage that was not reached.
std::string refinedText(const RefineSettings& asked, const RefineState& state) {
  if (state.rays == 0) return "nothing to refine";
  const std::string left = state.left < 0.0 ? "" : ", an estimated " + percentText(state.left) + " left";
  if (asked.until > 0.0 && state.left > asked.until) {
    printWarnings({"--refine=" + percentText(asked.until) + ": not reached; after " + std::to_string(state.rays) +
                   " rays a pixel, the most there are, an estimated " + percentText(state.left) + " are left"});
  }
  return "refined by " + std::to_string(state.rays) + " rays a pixel" + left;
}

/// What only shows once programs are compiled. `said`: remarks that are printed already.
void warnOfPicture(const OffscreenScene& shown, const std::vector<std::string>& said) {
  std::vector<std::string> remarks = shown.renderer().remarks();
  remarks.erase(std::remove_if(remarks.begin(), remarks.end(),
                               [&said](const std::string& remark) {
                                 return std::find(said.begin(), said.end(), remark) != said.end();
                               }),
                remarks.end());
  printWarnings(remarks);
}

void runRender(const RenderOptions& options) {
  useLargePages();
  const bool linear = requireExtension("-o", options.outputPath, {".png", ".exr"}) == ".exr";
  const FrameSize size = parseFrameSize(options.size);
  if (linear && options.view == kAllViews) {
    throw InputError("-o " + options.outputPath +
                     ": a sheet of all views must be a .png; an .exr holds the numbers of one view");
  }
  const RefineSettings refine = parseRefine(options.refine);
  if (refine.rays > 0) refuseBesideRefine(options);
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
  const ShownSettings settings{camera, options.probes == "on", bakedFolderOf(options.scenePath), {}, view};
  if (refine.rays > 0 && !options.report.quiet) warnOfUnrest(loaded.scene);
  shown.show(loaded.scene, loaded.models, settings);
  shown.renderer().refine(refine);
  captureShown(shown, interrupt, options.report.quiet);
  if (comparesDiffuse(options.view)) {
    shown.renderer().setDiffuseTruth(traceDiffuse(loaded, camera, options, interrupt));
  }
  if (refine.rays > 0) {
    shown.renderer().sharpenMirrors(size.height);
    captureShown(shown, interrupt, options.report.quiet);
  }
  if (!linear) exposeAutomatically(shown, loaded, settings, aspect);
  const std::vector<std::string> said = shown.renderer().remarks();
  const PictureTimes times = drawPicture(shown, options, linear, interrupt);
  if (!options.report.quiet) warnOfPicture(shown, said);

  const std::string refined =
      refine.rays > 0 && !options.report.quiet ? refinedText(refine, shown.renderer().refineState()) : std::string();

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
                ", camera " + camera.name + ", " + (refine.rays > 0 ? refined + ", " : std::string()) +
                std::to_string(stats.counters.facesCaptured) + " faces captured, " + seconds + " s of CPU time\n");
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
