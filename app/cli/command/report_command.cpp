// See report_command.h.
#include "app/cli/command/report_command.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command/short_run.h"
#include "app/cli/farm/farm_options.h"
#include "app/cli/farm/farm_script.h"
#include "app/cli/options/render_options.h"
#include "app/cli/report/fit_report.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/scene_review.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "app/session/valid_json.h"
#include "app/web/review_page.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/platform/heap.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

struct ReportCommandOptions {
  std::vector<std::string> scenePaths;
  std::string outputPath, size, technique;
  std::optional<std::string> failAbove;
  std::vector<std::string> cameras, assignments;
  std::optional<int> rays;
  std::uint64_t seed = 1;
  bool quick = false;
  FarmOptions farm;
  FitOptions fit;
  ReportOptions report;
};

/// What follows the program's name. Of a script, paths are absolute.
std::vector<std::string> wordsOf(const ReportCommandOptions& options, bool absolute) {
  const auto path = [&](const std::string& text) { return absolute ? farmPath(text) : text; };
  std::vector<std::string> words = {"report"};
  for (const std::string& scene : options.scenePaths) words.push_back(path(scene));
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  for (const std::string& camera : options.cameras) add("--camera", camera);
  add("--technique", options.technique);
  add("--size", options.size);
  if (options.rays) add("--rays", std::to_string(*options.rays));
  if (options.quick) words.emplace_back("--quick");
  if (options.seed != 1) add("--seed", std::to_string(options.seed));
  for (const std::string& assignment : options.assignments) add("--set", assignment);
  add("--as", options.fit.kind);
  add("--light", options.fit.light);
  add("--fail-above", options.failAbove.value_or(""));
  add("-o", path(options.outputPath));
  return words;
}

std::string commandOf(const ReportCommandOptions& options) {
  std::string text = "boxprobe";
  for (const std::string& word : wordsOf(options, false)) text += " " + shellWord(word);
  return text;
}

/// Of all that traced pictures and fits depend on.
std::string reviewKey(const LoadedScene& loaded, const ReviewSettings& settings) {
  ContentHash hash;
  hash.add("report").add(loadedSceneKey(loaded)).add(settings.width).add(settings.height).add(settings.paths);
  hash.add(std::to_string(settings.seed));
  for (const Camera& camera : settings.cameras) hash.add(camera.name);
  return hash.text();
}

std::optional<double> limitOf(const ReportCommandOptions& options) {
  if (!options.failAbove) return std::nullopt;
  char* end = nullptr;
  const double limit = std::strtod(options.failAbove->c_str(), &end);
  if (options.failAbove->empty() || *end != '\0' || !std::isfinite(limit) || limit < 0.0) {
    throw InputError("--fail-above " + *options.failAbove +
                     ": expected a relative RMSE of 0 or more, as in --fail-above 0.2");
  }
  return limit;
}

ReviewSettings settingsOf(const ReportCommandOptions& options) {
  const FrameSize size = parseFrameSize(!options.size.empty() ? options.size : options.quick ? "320x180" : "640x360");
  ReviewSettings settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.paths = options.rays.value_or(options.quick ? 32 : settings.paths);
  settings.seed = options.seed;
  return settings;
}

LoadedScene loadOne(const std::string& path, const ReportCommandOptions& options, const ReviewSettings& settings,
                    const InterruptGuard& interrupt) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  LoadedScene loaded =
      loadSceneShown(path, options.assignments, interrupt, options.report.quiet, parseFitWishes(options.fit, aspect));
  chooseTechnique(loaded.scene, options.technique);
  return loaded;
}

void addRows(const SceneReview& review, std::vector<WholeRow>& rows, nlohmann::ordered_json& probes) {
  for (const ReviewedCamera& camera : review.cameras) {
    rows.push_back({review.name, camera.camera.name, "as it is", "all", camera.parts});
  }
  for (const ReviewedProbe& probe : review.probes) {
    nlohmann::ordered_json json = {{"scene", review.name}, {"name", probe.probe.name}, {"textureBytes", probe.bytes}};
    if (probe.fit) json["verdict"] = fitVerdict(*probe.fit);
    if (probe.fit) json["fit"] = fitJson(probe.probe, *probe.fit);
    probes.push_back(json);
  }
}

/// Of every scene's traced pictures and fits.
void makeShare(const ReportCommandOptions& options, const ReviewSettings& settings,
               const std::vector<std::vector<Camera>>& cameras, const InterruptGuard& interrupt) {
  for (std::size_t i = 0; i < options.scenePaths.size(); ++i) {
    const LoadedScene loaded = loadOne(options.scenePaths[i], options, settings, interrupt);
    if (!options.report.quiet) printWarnings(loaded.warnings);
    ReviewSettings wanted = settings;
    wanted.cameras = cameras[i];
    const auto shared = sharedWork(options.farm, options.outputPath, reviewKey(loaded, wanted));
    wanted.shared = shared.get();
    {
      ProgressLine line(options.scenePaths[i], !options.report.quiet);
      const bool complete = reviewShare(loaded, wanted, [&](double done) {
        line.show(done);
        return !interrupt.interrupted();
      });
      if (!complete) throw WorkError("interrupted; the same command goes on from what is in " + shared->folder());
    }
    if (!options.report.quiet) printResult(options.scenePaths[i] + ", " + shareText(*shared));
  }
}

void runReport(const ReportCommandOptions& options) {
  measureWithoutAnisotropy();
  useLargePages();
  requireExtension("-o", options.outputPath, {".html", ".htm"});
  const std::optional<double> limit = limitOf(options);
  const ReviewSettings settings = settingsOf(options);
  requireWritable("-o", options.outputPath);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  if (!options.farm.script.empty()) {
    FarmWork work;
    work.name = work.noun = "report";
    work.words = wordsOf(options, true);
    return printDocument(farmScript(options.farm, work));
  }
  const InterruptGuard interrupt;

  // What is wrong with one of many is told before the first is traced.
  std::vector<std::vector<Camera>> cameras;
  for (const std::string& path : options.scenePaths) {
    const LoadedScene loaded = loadOne(path, options, settings, interrupt);
    cameras.emplace_back();
    for (const std::string& name : options.cameras) cameras.back().push_back(chooseCamera(loaded.scene, name));
    interrupt.check();
  }
  if (!options.farm.shard.empty()) return makeShare(options, settings, cameras, interrupt);
  std::vector<std::unique_ptr<SharedWork>> shares;
  OffscreenScene shown(
      {"boxprobe report", settings.width, settings.height, 1, options.report.quiet, false, options.report.offscreen});
  ReviewPage page({commandOf(options), limit, settings});
  std::vector<WholeRow> rows;
  nlohmann::ordered_json probes = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < options.scenePaths.size(); ++i) {
    LoadedScene loaded = loadOne(options.scenePaths[i], options, settings, interrupt);
    if (!options.report.quiet) printWarnings(loaded.warnings);
    ReviewSettings wanted = settings;
    wanted.cameras = cameras[i];
    if (options.farm.merge) {
      shares.push_back(sharedWork(options.farm, options.outputPath, reviewKey(loaded, wanted)));
      wanted.shared = shares.back().get();
    }
    std::optional<SceneReview> review;
    {
      ProgressLine line(options.scenePaths[i], !options.report.quiet);
      review = reviewScene(std::move(loaded), shown, wanted, [&](double done) {
        line.show(done);
        return !interrupt.interrupted();
      });
    }
    if (!review) throw WorkError("interrupted; " + options.outputPath + " was not written");
    for (const ReviewedCamera& camera : review->cameras) {
      if (options.report.quiet || !tooNoisy(camera.all())) continue;
      printWarnings({review->name + ", camera " + camera.camera.name +
                     ": the traced picture's noise is larger than the error; use more --rays"});
    }
    page.add(*review);
    addRows(*review, rows, probes);
  }
  writeTextAtomically(options.outputPath, page.text());
  for (const auto& share : shares) share->remove();
  if (!options.report.statsPath.empty()) {
    writeTextAtomically(options.report.statsPath, statsJson(collectStats(shown.renderer(), shown.window())));
  }
  std::string above;
  std::size_t failed = 0;
  for (const WholeRow& row : rows) {
    if (!limit || row.parts.front().relativeRmse <= *limit) continue;  // what is not a number fails
    char error[32];
    std::snprintf(error, sizeof error, " %.3f", row.parts.front().relativeRmse);
    above += (failed++ == 0 ? "" : ", ") + row.scene + "/" + row.camera + error;
  }
  if (options.report.json) {
    nlohmann::ordered_json json = wholeJson(rows, true);
    json["probes"] = probes;
    json["failAbove"] = limit ? nlohmann::ordered_json(*limit) : nlohmann::ordered_json();
    json["passed"] = failed == 0;
    printDocument(validJson(json));
  } else if (!options.report.quiet) {
    printResult(wholeTable(rows) + options.outputPath + "\n");
  }
  if (failed > 0) {
    throw WorkError(options.outputPath + ": the error is above --fail-above " + *options.failAbove + ": " + above);
  }
}

}  // namespace

Subcommand addReportCommand(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("report", "Review scenes in one HTML file: drawn, path traced, how far apart");
  const auto options = std::make_shared<ReportCommandOptions>();
  command
      ->add_option("SCENE", options->scenePaths,
                   "Scene files (.boxprobe.json) or bare models (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command->add_option("-o,--output", options->outputPath, "HTML file to write (.html)")->type_name("FILE")->required();
  command
      ->add_option(
          "--fail-above", options->failAbove,
          "Exit status 1 if the relative RMSE of a camera is above this, as in 0.2; the file is written all the "
          "same")
      ->type_name("ERROR");
  command->add_option("--camera", options->cameras, "This camera alone (repeatable; default: every camera)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--technique", options->technique, "Technique of every probe (default: the scene's)")
      ->type_name("ID");
  command->add_option("--size", options->size, "Size of the pictures (default 640x360; with --quick 320x180)")
      ->type_name("WxH");
  command->add_option("--rays", options->rays, "Paths per pixel of the traced pictures (default 128; with --quick 32)")
      ->check(CLI::Range(8, 65536).description(""))  // below, nothing is known of the noise
      ->type_name("N");
  command->add_flag("--quick", options->quick, "Small pictures and few paths");
  command->add_option("--seed", options->seed, "Seed of the paths")->capture_default_str();
  addFarmOptions(*command, options->farm);
  command->add_option("--set", options->assignments, "Change a field of every scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addFitOptions(*command, options->fit);
  addReportOptions(*command, options->report, "Print the errors as JSON");
  addOffscreenOption(*command, options->report);
  command->footer(
      "Exit status: 0 done, 1 a camera's error is above --fail-above or the work failed, 2 bad usage or bad input.\n"
      "Many processes: --emit, or --shard I/N in each of them and --merge at the end.\n"
      "Examples:\n"
      "  boxprobe report data/scenes/room.boxprobe.json -o room.html\n"
      "  boxprobe report data/scenes/*.boxprobe.json -o all.html --quick --fail-above 0.5");
  return {command, [options] { runReport(*options); }};
}

}  // namespace boxprobe
