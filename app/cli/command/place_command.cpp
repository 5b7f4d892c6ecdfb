// See place_command.h.
#include "app/cli/command/place_command.h"

#include <memory>
#include <string>
#include <vector>

#include "app/cli/options/render_options.h"
#include "app/cli/report/place_report.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/output_check.h"
#include "app/session/picture_check.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/fit/place_probes.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

struct PlaceCommandOptions {
  std::string scenePath, outputPath;
  int most = 64;
  double gainPercent = 2.0;
  bool keep = false, unchecked = false;
  FitOptions fit;
  std::vector<std::string> assignments;
  ReportOptions report;
};

/// The pictures of what was placed, compared; nothing if that is not wanted, or there is nothing to draw with.
std::optional<PictureCheck> compared(const PlaceCommandOptions& options, const LoadedScene& loaded,
                                     Placement& placement, const InterruptGuard& interrupt, RunStats& stats) {
  if (options.unchecked || placement.rooms.empty()) return std::nullopt;
  std::optional<PictureCheck> check;
  ProgressLine line("comparing pictures", !options.report.quiet);
  try {
    OffscreenScene shown({"boxprobe place", 16, 16, 1, options.report.quiet, false, options.report.offscreen, true});
    check = checkPictures(loaded, placement, shown, [&](double done) {
      line.show(done);
      return !interrupt.interrupted();
    });
    stats = collectStats(shown.renderer(), shown.window());
  } catch (const InputError& error) {
    if (!options.report.quiet) printWarnings({std::string("pictures were not compared: ") + error.what()});
    return std::nullopt;
  }
  interrupt.check();
  nameProbes(placement);
  return check;
}

void runPlace(const PlaceCommandOptions& options) {
  if (!options.outputPath.empty()) {
    requireExtension("-o", options.outputPath, {".json"});
    requireWritable("-o", options.outputPath);
  }
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const InterruptGuard interrupt;
  const FitWishes wishes = parseFitWishes(options.fit, FitWishes{}.aspect);
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet, wishes);
  if (!options.report.quiet) printWarnings(loaded.warnings);

  PlaceSettings settings;
  settings.most = static_cast<std::size_t>(options.most);
  settings.leastGain = 0.01 * options.gainPercent;
  settings.keep = options.keep && !loaded.fit;  // a bare model's probe is nobody's own
  settings.inverted = wishes.kind && *wishes.kind != ModelKind::Object;
  std::optional<Placement> placement;
  {
    ProgressLine line("placing", !options.report.quiet);
    placement = placeProbes(loaded.scene, loaded.models, settings, [&](double done) {
      line.show(done);
      return !interrupt.interrupted();
    });
  }
  interrupt.check();
  RunStats stats;
  const std::optional<PictureCheck> pictures = compared(options, loaded, *placement, interrupt, stats);
  const PictureCheck* shown = pictures ? &*pictures : nullptr;
  loaded.scene.probes = placement->all();
  if (!options.outputPath.empty()) saveSceneFile(loaded.scene, options.outputPath);
  if (options.report.json) {
    printDocument(placeJson(*placement, shown).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                  "\n");
  } else if (!options.report.quiet) {
    printResult(placeText(*placement, shown));
  }
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
}

}  // namespace

Subcommand addPlaceCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("place", "Find the rooms of a model and place fitted probes in them");
  const auto options = std::make_shared<PlaceCommandOptions>();
  command
      ->add_option("SCENE", options->scenePath,
                   "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command
      ->add_option("-o,--output", options->outputPath,
                   "Write the scene with these probes to this file, *.boxprobe.json (default: nothing is written)")
      ->type_name("FILE");
  command->add_option("--most", options->most, "At most so many probes, those that are kept included (default 64)")
      ->check(CLI::Range(1, 10000).description(""))
      ->type_name("N");
  command
      ->add_option("--gain", options->gainPercent,
                   "What one more probe in a room must gain, in percent of what its probes gain in all (default 2)")
      ->check(CLI::Range(0.0, 100.0).description(""))
      ->type_name("PERCENT");
  command->add_flag("--keep", options->keep,
                    "Keep the scene's probes, and place others only in rooms without one (default: replace them)");
  command->add_flag("--unchecked", options->unchecked,
                    "Do not compare pictures with the path tracer's: what was placed is proposed as it is");
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addFitOptions(*command, options->fit);
  addOffscreenOption(*command, options->report);
  addReportOptions(*command, options->report, "Print rooms, probes and decisions as JSON");
  command->footer(
      "Examples:\n"
      "  boxprobe place flat.glb -o flat.boxprobe.json\n"
      "  boxprobe place data/scenes/building.boxprobe.json --most 4 --gain 5 --json");
  return {command, [options] { runPlace(*options); }};
}

}  // namespace boxprobe
