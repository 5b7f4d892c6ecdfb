// See info_command.h.
#include "app/cli/command/info_command.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command/short_run.h"
#include "app/cli/options/render_options.h"
#include "app/cli/report/frame_info.h"
#include "app/cli/report/report_text.h"
#include "app/cli/report/scene_report.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_reference.h"
#include "filters/platform/heap.h"

namespace boxprobe {

namespace {

struct InfoOptions {
  std::string scenePath;
  std::vector<std::string> assignments;
  bool frame = false, costs = false, fields = false;
  std::string camera, size = "1280x720";
  FitOptions fit;
  ReportOptions report;
};

void runInfo(const InfoOptions& options) {
  useLargePages();
  if (options.fields) {
    const std::string reference = options.report.json ? sceneReferenceJson() : sceneReferenceMarkdown();
    printDocument(reference);
    return;
  }
  if (options.scenePath.empty()) throw InputError("SCENE is required; see boxprobe info --help");
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const FrameSize size = parseFrameSize(options.size);
  LoadedScene loaded = loadScene(options.scenePath, options.assignments, {},
                                 parseFitWishes(options.fit, static_cast<double>(size.width) / size.height));
  // The frame comes first: it may tell the exposure.
  std::optional<FrameReport> frame;
  FrameCosts costs;
  if (options.frame) {
    frame = drawnFrameReport(loaded, options.scenePath, options.camera, size, options.report,
                             options.costs ? &costs : nullptr);
  }
  nlohmann::ordered_json report = sceneReport(loaded);
  std::string text = options.report.json ? std::string() : sceneReportText(report);
  if (frame) {
    report["frame"] = frameReportJson(*frame);
    text += frameReportText(*frame);
    if (options.costs) report["frame"]["costs"] = frameCostsJson(costs);
    if (options.costs) text += frameCostsText(costs);
  }
  options.report.json ? printDocument(validJson(report)) : printResult(text);
  // Without --frame nothing is drawn or captured here; with it, what that took is in the report.
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(RunStats{}));
}

}  // namespace

Subcommand addInfoCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Describe a scene; list unsupported features");
  const auto options = std::make_shared<InfoOptions>();
  CLI::Option* scene = command->add_option(
      "SCENE", options->scenePath, "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)");
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  CLI::Option* frame =
      command->add_flag("--frame", options->frame, "Draw a frame and report what it did and what it skipped");
  command->add_flag("--costs", options->costs, "Measure where the time of that frame goes, by parts and by objects")
      ->needs(frame);
  command->add_option("--camera", options->camera, "Camera of that frame");
  command->add_option("--size", options->size, "Size of that frame in pixels")->type_name("WxH")->capture_default_str();
  addFitOptions(*command, options->fit);
  command->add_flag("--fields", options->fields, "Without a scene: list every field of the scene file")
      ->excludes(scene);
  addReportOptions(*command, options->report, "Print the explanation as JSON");
  addOffscreenOption(*command, options->report);
  command->footer("Examples:\n  boxprobe info data/scenes/building.boxprobe.json\n  boxprobe info --fields");
  return {command, [options] { runInfo(*options); }};
}

}  // namespace boxprobe
