// See fit_command.h.
#include "app/cli/command/fit_command.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/report/fit_report.h"
#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/fit/fit_probe.h"
#include "filters/fit/model_kind.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

struct FitCommandOptions {
  std::string scenePath, outputPath, faces, origin = "keep", yaw;
  std::vector<std::string> probes, assignments;
  ReportOptions report;
};

/// "+x,-z".
std::array<bool, kFaces> parseFaces(const std::string& text) {
  std::array<bool, kFaces> faces{};
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    int face = 0;
    while (face < kFaces && name != faceName(face)) ++face;
    if (face == kFaces) {
      throw InputError("--faces " + text + ": no face " + name + "; there are: -x, +x, -y, +y, -z, +z");
    }
    faces[static_cast<std::size_t>(face)] = true;
  }
  return faces;
}

BoxFitSettings settingsOf(const FitCommandOptions& options) {
  BoxFitSettings settings;
  if (!options.faces.empty()) settings.faces = parseFaces(options.faces);
  // Single faces are fitted as the box stands, unless asked otherwise.
  settings.yaw = options.yaw.empty() ? options.faces.empty() : options.yaw == "fit";
  return settings;
}

std::vector<std::size_t> chosenProbes(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; names.empty() && i < scene.probes.size(); ++i) chosen.push_back(i);
  for (const std::string& name : names) {
    const std::optional<std::size_t> index = findProbe(scene, name);
    if (!index) {
      std::string there;
      for (const Probe& probe : scene.probes) there += (there.empty() ? "" : ", ") + probe.name;
      throw InputError("--probe " + name +
                       ": no probe of that name; the scene has: " + (there.empty() ? "none" : there));
    }
    chosen.push_back(*index);
  }
  return chosen;
}

/// One fit after another, from what loading found of a bare model or from the probe as it stands.
std::vector<BoxFit> fitsOf(const FitCommandOptions& options, const LoadedScene& loaded,
                           const std::vector<std::size_t>& chosen, const InterruptGuard& interrupt) {
  if (loaded.fit && loaded.fit->box && options.origin == "keep") return {*loaded.fit->box};
  std::vector<BoxFit> fits;
  const BoxFitSettings settings = settingsOf(options);
  ProgressLine line("fitting", !options.report.quiet);
  ProbeFitter fitter(loaded.scene, loaded.models);
  for (const std::size_t index : chosen) {
    const auto progress = [&](double done) {
      line.show((static_cast<double>(fits.size()) + done) / static_cast<double>(chosen.size()));
      return !interrupt.interrupted();
    };
    const Probe& probe = loaded.scene.probes[index];
    std::optional<BoxFit> fit = options.origin == "propose" ? fitter.fitWithOrigin(probe, settings, progress)
                                                            : fitter.fit(probe, settings, progress);
    if (!fit) interrupt.check();
    fits.push_back(*std::move(fit));
  }
  return fits;
}

/// In the scene as it is given: what the other probes do is not asked.
std::vector<std::optional<FitLightErrors>> lightsOf(const LoadedScene& loaded, const std::vector<Probe>& before,
                                                    const std::vector<std::size_t>& chosen,
                                                    const std::vector<BoxFit>& fits, const FitCommandOptions& options,
                                                    const InterruptGuard& interrupt) {
  ProgressLine line("tracing light", !options.report.quiet);
  ProbeFitter fitter(loaded.scene, loaded.models);
  std::vector<std::optional<FitLightErrors>> lights;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (fits[i].outcome == FitOutcome::Open || fits[i].outcome == FitOutcome::Inside) {
      lights.emplace_back();
      continue;
    }
    lights.push_back(fitLightErrors(loaded.scene, loaded.models, fitter, before[chosen[i]], fits[i], [&](double done) {
      line.show((static_cast<double>(i) + done) / static_cast<double>(fits.size()));
      return !interrupt.interrupted();
    }));
    interrupt.check();
  }
  return lights;
}

void runFit(const FitCommandOptions& options) {
  if (!options.outputPath.empty()) {
    requireExtension("-o", options.outputPath, {".json"});
    requireWritable("-o", options.outputPath);
  }
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const InterruptGuard interrupt;
  FitWishes wishes;
  wishes.box = settingsOf(options);
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet, wishes);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  const std::vector<std::size_t> chosen = chosenProbes(loaded.scene, options.probes);
  const ModelKind kind = loaded.fit ? loaded.fit->kind : surveyModel(TriangleRays(loaded.scene, loaded.models)).kind;

  const std::vector<Probe> before = loaded.scene.probes;
  const std::vector<BoxFit> fits = fitsOf(options, loaded, chosen, interrupt);
  interrupt.check();
  nlohmann::ordered_json report = {{"kind", modelKindId(kind)}, {"probes", nlohmann::ordered_json::array()}};
  std::vector<std::optional<FitLightErrors>> lights(fits.size());
  if (options.report.json || !options.report.quiet) lights = lightsOf(loaded, before, chosen, fits, options, interrupt);
  std::string text;
  if (fits.empty()) {
    text = std::string(modelKindId(kind)) + ": no probe, nothing to fit; the surroundings alone are reflected\n";
  }
  for (std::size_t i = 0; i < fits.size(); ++i) {
    report["probes"].push_back(fitJson(before[chosen[i]], fits[i], lights[i]));
    text += fitText(before[chosen[i]], fits[i], lights[i]);
    if (!loaded.fit || options.origin == "propose") loaded.scene.probes[chosen[i]] = fits[i].probe;
  }
  if (!options.outputPath.empty()) saveSceneFile(loaded.scene, options.outputPath);
  if (options.report.json) {
    printDocument(report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  } else if (!options.report.quiet) {
    printResult(text);
  }
  // Nothing is drawn or captured here, and the counters say so.
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(RunStats{}));
}

}  // namespace

Subcommand addFitCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("fit", "Fit the boxes of probes to what they see");
  const auto options = std::make_shared<FitCommandOptions>();
  command
      ->add_option("SCENE", options->scenePath,
                   "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command->add_option("--probe", options->probes, "Fit this probe alone (repeatable; default: every probe)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--origin", options->origin, "propose: also look for a better capture origin (default keep)")
      ->check(CLI::IsMember({"keep", "propose"}).description(""))
      ->type_name("keep|propose");
  command->add_option("--faces", options->faces, "Fit these faces of the box alone, as in +x,-z (default: all six)")
      ->type_name("FACES");
  command->add_option("--yaw", options->yaw, "May the box turn about +y? (default fit; keep with --faces)")
      ->check(CLI::IsMember({"keep", "fit"}).description(""))
      ->type_name("keep|fit");
  command
      ->add_option("-o,--output", options->outputPath,
                   "Write the scene with the fit to this file, *.boxprobe.json (default: nothing is written)")
      ->type_name("FILE");
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addReportOptions(*command, options->report, "Print the result as JSON");
  command->footer(
      "Examples:\n"
      "  boxprobe fit data/scenes/building.boxprobe.json\n"
      "  boxprobe fit data/scenes/building.boxprobe.json --probe room --faces +x,-z -o fitted.boxprobe.json");
  return {command, [options] { runFit(*options); }};
}

}  // namespace boxprobe
