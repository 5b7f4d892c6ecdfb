// See explain_command.h.
#include "app/cli/command/explain_command.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command/short_run.h"
#include "app/cli/options/render_options.h"
#include "app/session/explanation_json.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/opened_glb.h"
#include "app/session/output_check.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/explain/explanation_text.h"
#include "filters/io/files/atomic_file.h"
#include "filters/math/technique/technique_table.h"
#include "filters/platform/heap.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

namespace {

struct ExplainOptions {
  std::string scenePath;
  std::string pixel;
  std::string size = "1280x720";
  std::string camera;
  std::string technique;
  std::vector<std::string> assignments;
  ReportOptions report;
};

glm::ivec2 parsePixel(const std::string& text, const FrameSize& size) {
  glm::ivec2 pixel(0);
  int used = 0;
  const bool two = std::sscanf(text.c_str(), "%d,%d%n", &pixel.x, &pixel.y, &used) == 2;
  if (!two || static_cast<std::size_t>(used) != text.size()) {
    throw InputError("--pixel " + text + ": expected X,Y in pixels from the top left, as in 640,360");
  }
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) {
    throw InputError("--pixel " + text + ": outside the picture of " + std::to_string(size.width) + " x " +
                     std::to_string(size.height) + "; X and Y count from 0 at the top left, --size sets the picture");
  }
  return pixel;
}

void runExplain(const ExplainOptions& options) {
  useLargePages();
  const FrameSize size = parseFrameSize(options.size);
  const glm::ivec2 pixel = parsePixel(options.pixel, size);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);

  const InterruptGuard interrupt;
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet);
  chooseTechnique(loaded.scene, options.technique);
  loaded.warnings = sceneWarnings(loaded.scene, loaded.models);  // of the technique that is used
  const Camera camera = chooseCamera(loaded.scene, options.camera);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  interrupt.check();

  OffscreenScene shown({"boxprobe explain", size.width, size.height, 1, options.report.quiet, false,
                        options.report.offscreen, drawsLittle(1, loaded.scene.probes.size())});
  ShownSettings settings{camera};
  settings.bakedFolder = bakedFolderOf(options.scenePath);
  shown.show(loaded.scene, loaded.models, settings);
  captureShown(shown, interrupt, options.report.quiet);
  const Explanation explanation = shown.renderer().explain(pixel.x, pixel.y, size.width, size.height);
  shown.requireHealthy();
  const Verdict verdict = verdictOf(explanation, loaded.scene);
  options.report.json ? printDocument(explanationJson(explanation, verdict))
                      : printResult(explanationText(explanation, {}, verdict));

  if (!options.report.statsPath.empty()) {
    RunStats stats = collectStats(shown.renderer(), shown.window());
    stats.startToFirstFrameCpuSeconds = processCpuSeconds();
    writeTextAtomically(options.report.statsPath, statsJson(stats));
  }
}

}  // namespace

Subcommand addExplainCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("explain", "Explain step by step how one pixel gets its colour");
  const auto options = std::make_shared<ExplainOptions>();
  command
      ->add_option("SCENE", options->scenePath,
                   "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command->add_option("--pixel", options->pixel, "Pixel to explain; 0,0 is the top left of the picture")
      ->type_name("X,Y")
      ->required();
  command->add_option("--size", options->size, "Width and height of the picture (default 1280x720)")->type_name("WxH");
  command->add_option("--camera", options->camera, "Camera of the scene (default: main, or else the first)")
      ->type_name("NAME");
  command
      ->add_option("--technique", options->technique,
                   "Technique of every probe (default: the scene's): " + techniqueIdList())
      ->type_name("ID");
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addReportOptions(*command, options->report, "Print the explanation as JSON");
  addOffscreenOption(*command, options->report);
  command->footer(
      "Example:\n"
      "  boxprobe explain data/scenes/building.boxprobe.json --pixel 640,500");
  return {command, [options] { runExplain(*options); }};
}

}  // namespace boxprobe
