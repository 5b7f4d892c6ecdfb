// See place_command.h.
#include "app/cli/command/place_command.h"

#include <memory>
#include <string>
#include <vector>

#include "app/cli/farm/farm_options.h"
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
#include "filters/core/base/number_text.h"
#include "filters/fit/place_probes.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

struct PlaceCommandOptions {
  std::string scenePath, outputPath;
  int most = 64;
  double gainPercent = 2.0;
  bool keep = false, unchecked = false, fitsOnly = false;
  FarmOptions farm;
  FitOptions fit;
  std::vector<std::string> assignments;
  ReportOptions report;
};

/// The pictures of what was placed, compared; nothing if that is not wanted, or there is nothing to draw with.
std::optional<PictureCheck> compared(const PlaceCommandOptions& options, const LoadedScene& loaded,
                                     const SharedWork* shared, Placement& placement, const InterruptGuard& interrupt,
                                     RunStats& stats) {
  if (options.unchecked || placement.rooms.empty()) return std::nullopt;
  std::optional<PictureCheck> check;
  PictureCheckSettings settings;
  settings.shared = shared;
  ProgressLine line("comparing pictures", !options.report.quiet);
  try {
    OffscreenScene shown({"boxprobe place", 16, 16, 1, options.report.quiet, false, options.report.offscreen, true});
    const auto progress = [&](double done) {
      line.show(done);
      return !interrupt.interrupted();
    };
    check = checkPictures(loaded, placement, shown, progress, settings);
    stats = collectStats(shown.renderer(), shown.window());
  } catch (const InputError& error) {
    if (!options.report.quiet) printWarnings({std::string("pictures were not compared: ") + error.what()});
    return std::nullopt;
  }
  interrupt.check();
  nameProbes(placement);
  return check;
}

/// Of all that fits and pictures depend on.
std::string placeKey(const LoadedScene& loaded, const PlaceSettings& settings) {
  ContentHash hash;
  // The number tells what this program shares from what older ones did, which had other eyes.
  hash.add("place 2").add(loadedSceneKey(loaded)).add(static_cast<double>(settings.most)).add(settings.leastGain);
  hash.add(settings.keep ? 1.0 : 0.0).add(settings.inverted ? 1.0 : 0.0).add(settings.rays);
  return hash.text();
}

std::string scriptOf(const PlaceCommandOptions& options) {
  FarmWork work;
  work.name = "place";
  work.noun = "placing";
  if (options.outputPath.empty()) throw InputError("--emit: add -o FILE, which the script's last command writes");
  work.words = {"place", farmPath(options.scenePath), "-o", farmPath(options.outputPath)};
  const auto add = [&work](const std::string& option, const std::string& value) {
    if (!value.empty()) work.words.insert(work.words.end(), {option, value});
  };
  const PlaceCommandOptions usual;
  if (options.most != usual.most) add("--most", std::to_string(options.most));
  if (options.gainPercent != usual.gainPercent) add("--gain", numberText(options.gainPercent));
  for (const std::string& assignment : options.assignments) add("--set", assignment);
  add("--as", options.fit.kind);
  add("--light", options.fit.light);
  if (options.keep) work.words.emplace_back("--keep");
  if (options.unchecked) work.words.emplace_back("--unchecked");
  work.steps = {{"--fits-only"}};
  if (!options.unchecked) work.steps.emplace_back();  // pictures from the rooms, which want all fits
  return farmScript(options.farm, work);
}

void runPlace(const PlaceCommandOptions& options) {
  if (!options.outputPath.empty()) {
    requireExtension("-o", options.outputPath, {".json"});
    requireWritable("-o", options.outputPath);
  }
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  if (!options.farm.script.empty()) return printDocument(scriptOf(options));
  const InterruptGuard interrupt;
  const FitWishes wishes = parseFitWishes(options.fit, FitWishes{}.aspect);
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet, wishes);
  if (!options.report.quiet) printWarnings(loaded.warnings);

  PlaceSettings settings;
  settings.most = static_cast<std::size_t>(options.most);
  settings.leastGain = 0.01 * options.gainPercent;
  settings.keep = options.keep && !loaded.fit;  // a bare model's probe is nobody's own
  settings.inverted = wishes.kind && *wishes.kind != ModelKind::Object;
  const auto shared = sharedWork(options.farm, options.outputPath, placeKey(loaded, settings));
  const bool sharing = shared && shared->sharing();
  settings.shared = shared.get();
  std::optional<Placement> placement;
  {
    ProgressLine line("placing", !options.report.quiet);
    const auto progress = [&](double done) {
      line.show(done);
      return !interrupt.interrupted();
    };
    if (sharing) fitSharedRooms(loaded.scene, loaded.models, settings, progress);
    if (!options.fitsOnly) placement = placeProbes(loaded.scene, loaded.models, settings, progress);
  }
  interrupt.check();
  RunStats stats;
  std::optional<PictureCheck> pictures;
  if (placement) pictures = compared(options, loaded, shared.get(), *placement, interrupt, stats);
  if (sharing) {
    if (!options.report.quiet) printResult(shareText(*shared));
    if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
    return;
  }
  const PictureCheck* shown = pictures ? &*pictures : nullptr;
  loaded.scene.probes = placement->all();
  if (!options.outputPath.empty()) saveSceneFile(loaded.scene, options.outputPath);
  if (shared) shared->remove();
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
  addFarmOptions(*command, options->farm);
  command
      ->add_flag("--fits-only", options->fitsOnly, "With --shard: make this share's fits and compare no pictures yet")
      ->needs("--shard");
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addFitOptions(*command, options->fit);
  addOffscreenOption(*command, options->report);
  addReportOptions(*command, options->report, "Print rooms, probes and decisions as JSON");
  command->footer(
      "Many processes: --emit, or --shard I/N in each of them, first all with --fits-only, and --merge at the end.\n"
      "Examples:\n"
      "  boxprobe place flat.glb -o flat.boxprobe.json\n"
      "  boxprobe place data/scenes/building.boxprobe.json --most 4 --gain 5 --json");
  return {command, [options] { runPlace(*options); }};
}

}  // namespace boxprobe
