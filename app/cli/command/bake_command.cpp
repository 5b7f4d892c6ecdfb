// See bake_command.h.
#include "app/cli/command/bake_command.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/nearest_name.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/files/atomic_file.h"

namespace boxprobe {

namespace {

struct BakeOptions {
  std::string scenePath;
  std::string folder;  ///< empty: beside the scene
  std::vector<std::string> probes;
  std::vector<std::string> assignments;
  ReportOptions report;
};

/// The probes to make: those named, else every baked one.
std::vector<std::string> chooseProbes(const Scene& scene, const std::vector<std::string>& wanted) {
  std::vector<std::string> all, baked;
  for (const Probe& probe : scene.probes) {
    all.push_back(probe.name);
    if (probe.mode == ProbeMode::Baked) baked.push_back(probe.name);
  }
  for (const std::string& name : wanted) {
    const auto index = findProbe(scene, name);
    if (!index) {
      throw InputError("--probe " + name + ": the scene has no such probe; " +
                       (all.empty() ? "it has none" : "there are: " + nameList(all)));
    }
    if (scene.probes[*index].mode != ProbeMode::Baked) {
      throw InputError("--probe " + name + ": its mode is not baked, so there is nothing to bake");
    }
  }
  return wanted.empty() ? baked : wanted;
}

/// Makes what is missing and writes each probe as soon as it is finished, so that work that is stopped goes on from
/// there. Returns the files written.
std::vector<std::string> bakeProbes(OffscreenScene& shown, const std::vector<std::string>& probes,
                                    const std::string& folder, const InterruptGuard& interrupt, bool quiet) {
  const SceneRenderer& renderer = shown.renderer();
  std::vector<std::string> files;
  std::set<std::string> toWrite(probes.begin(), probes.end());
  bool skyToWrite = true;
  const auto writeFinished = [&] {
    const auto save = [&](const std::string& name) {
      shown.requireHealthy();
      const std::string path = renderer.saveBaked(name, folder, "Boxprobe " BOXPROBE_VERSION);
      if (!path.empty()) files.push_back(path);
      return !path.empty();
    };
    if (skyToWrite && renderer.counters().skyFacesCaptured > 0) skyToWrite = !save({});
    for (auto it = toWrite.begin(); it != toWrite.end();) {
      const bool finished = renderer.bakeState(*it) == BakeState::UpToDate && save(*it);
      it = finished ? toWrite.erase(it) : std::next(it);
    }
  };
  ProgressLine line("baking probes", !quiet);
  shown.capture([&](double fraction) {
    writeFinished();
    line.show(fraction);
    return !interrupt.interrupted();
  });
  return files;
}

void runBake(const BakeOptions& options) {
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const InterruptGuard interrupt;
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet);
  const std::vector<std::string> probes = chooseProbes(loaded.scene, options.probes);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  const std::string folder = options.folder.empty() ? BakeFolder::besideScene(options.scenePath) : options.folder;
  interrupt.check();

  OffscreenScene shown({"boxprobe bake", 16, 16, 1, options.report.quiet, false, options.report.offscreen});
  requireOutputFolder("-o", folder);
  ShownSettings settings;
  settings.bakedFolder = folder;
  settings.bakeTargets = probes;
  shown.show(loaded.scene, loaded.models, settings);
  std::vector<std::string> files;
  if (!probes.empty()) files = bakeProbes(shown, probes, folder, interrupt, options.report.quiet);
  shown.requireHealthy();
  if (!options.report.quiet) printWarnings(shown.renderer().remarks());
  if (interrupt.interrupted()) {
    throw WorkError("interrupted: " + std::to_string(files.size()) + " files are complete in " + folder +
                    "; the same command continues from there");
  }

  const RunStats stats = collectStats(shown.renderer(), shown.window());
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
  if (options.report.json) {
    printDocument(statsJson(stats));
  } else if (!options.report.quiet) {
    std::string text;
    for (const std::string& file : files) text += file + "\n";
    printResult(text + folder + ": " + std::to_string(probes.size()) + " baked probe(s), " +
                std::to_string(files.size()) + " file(s) written, " + std::to_string(stats.counters.facesCaptured) +
                " faces captured, " + std::to_string(stats.counters.levelsFiltered) + " levels filtered\n");
  }
}

}  // namespace

Subcommand addBakeCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("bake", "Capture and filter a scene's baked probes into files");
  const auto options = std::make_shared<BakeOptions>();
  command
      ->add_option("SCENE", options->scenePath,
                   "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for the EXR files (default: SCENE.probes beside the scene, where render and the window look "
                   "for them)")
      ->type_name("DIR");
  command->add_option("--probe", options->probes, "Bake only this probe (repeatable; default: every baked probe)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addReportOptions(*command, options->report, "Print the JSON that --stats writes");
  addOffscreenOption(*command, options->report);
  command->footer(
      "Skips probes whose file was made from the same inputs: a second call continues where the first one stopped\nand "
      "does nothing if nothing changed.\nExample:\n  boxprobe bake data/scenes/building.boxprobe.json -o "
      "out/building.probes --stats bake.json");
  return {command, [options] { runBake(*options); }};
}

}  // namespace boxprobe
