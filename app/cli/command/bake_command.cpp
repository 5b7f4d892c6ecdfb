// See bake_command.h.
#include "app/cli/command/bake_command.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/cli/command/short_run.h"
#include "app/cli/farm/bake_listing.h"
#include "app/cli/farm/bake_merge.h"
#include "app/cli/farm/bake_share.h"
#include "app/cli/farm/farm_script.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/output_check.h"
#include "app/session/program_name.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/scene/bounces.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/files/atomic_file.h"
#include "filters/platform/heap.h"
#include "filters/platform/name_pattern.h"
#include "filters/platform/process.h"

namespace boxprobe {

namespace {

struct BakeOptions {
  std::string scenePath;
  std::string folder;  ///< empty: beside the scene
  std::vector<std::string> probes, patterns;
  std::vector<std::string> assignments;
  std::string shard;   ///< empty: mpiexec's place, or all
  std::string script;  ///< kind of script to print
  int shards = 0;      ///< of that script; 0: as many as there are probes, 64 at most
  int bounce = 0;      ///< 0: all
  bool list = false, check = false, merge = false, mixed = false;
  std::vector<std::string> sources;  ///< to merge
  ReportOptions report;
};

bool matchesAny(const std::string& name, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return matchesPattern(pattern, name); });
}

/// The baked probes that are asked for: those named, those that match, else every one.
std::vector<Probe> chooseProbes(const Scene& scene, const BakeOptions& options) {
  std::vector<std::string> all;
  for (const Probe& probe : scene.probes) all.push_back(probe.name);
  const std::string there = all.empty() ? "it has none" : "there are: " + nameList(all);
  for (const std::string& name : options.probes) {
    const auto index = findProbe(scene, name);
    if (!index) throw InputError("--probe " + name + ": the scene has no such probe; " + there);
    if (scene.probes[*index].mode != ProbeMode::Baked) {
      throw InputError("--probe " + name + ": its mode is not baked, so there is nothing to bake");
    }
  }
  const std::set<std::string> named(options.probes.begin(), options.probes.end());
  std::vector<Probe> chosen;
  for (const Probe& probe : scene.probes) {
    if (probe.mode != ProbeMode::Baked) continue;
    const bool any = named.empty() && options.patterns.empty();
    if (any || named.count(probe.name) != 0 || matchesAny(probe.name, options.patterns)) chosen.push_back(probe);
  }
  if (chosen.empty() && !options.patterns.empty()) {
    throw InputError("--only " + options.patterns.front() + ": matches no baked probe; " + there);
  }
  return chosen;
}

std::vector<std::string> namesOf(const std::vector<Probe>& probes) {
  std::vector<std::string> names;
  for (const Probe& probe : probes) names.push_back(probe.name);
  return names;
}

/// Makes what is missing and writes each probe as soon as it is finished, so that work that is stopped goes on from
/// there. `earlier`: of which bounce the maps are, for those that are not the last. Returns the files written.
std::vector<std::string> bakeProbes(OffscreenScene& shown, const std::vector<std::string>& probes,
                                    const std::map<std::string, int>& earlier, const std::string& folder,
                                    const InterruptGuard& interrupt, bool quiet) {
  const SceneRenderer& renderer = shown.renderer();
  std::vector<std::string> files;
  std::set<std::string> toWrite;
  for (const std::string& name : probes) {
    if (renderer.bakeState(name) != BakeState::FromFile) toWrite.insert(name);
  }
  bool skyToWrite = true;
  const auto writeFinished = [&] {
    const auto save = [&](const std::string& name) {
      shown.requireHealthy();
      const auto bounce = earlier.find(name);
      const std::string path =
          renderer.saveBaked(name, folder, kProgramName, bounce == earlier.end() ? 0 : bounce->second);
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

/// What the scene's probes are after so many bounces, and which of them are not done by then.
std::map<std::string, int> limitBounces(Scene& scene, const std::vector<Probe>& probes, int bounce,
                                        const OffscreenScene& shown) {
  std::map<std::string, int> earlier;
  for (const Probe& probe : probes) {
    const std::vector<std::string> keys = shown.renderer().bakeKeys(probe.name);
    // A bounce that shows nothing new has the maps of the one before: they are final.
    const auto last = static_cast<std::size_t>(std::min(bounce, probe.bounces)) - 1;
    if (last < keys.size() && keys[last] != keys.back()) earlier[probe.name] = bounce;
  }
  for (Probe& probe : scene.probes) probe.bounces = std::min(probe.bounces, bounce);
  return earlier;
}

/// Lists, checks or merges; true if that was all.
bool reportOnly(const BakeOptions& options, const std::vector<Probe>& probes, LampForm lamps,
                const OffscreenScene& shown, const std::string& folder) {
  if (!options.list && !options.check && !options.merge) return false;
  std::vector<BakeRow> rows = bakeRows(shown, probes, BakeFolder(folder));
  if (options.list) {
    if (options.report.json)
      printDocument(bakeListJson(rows));
    else
      printResult(bakeListText(rows, probes, folder, lamps == LampForm::Shapes));
    return true;
  }
  if (options.merge) {
    requireOutputFolder("-o", folder);
    const BakeMerge merge = mergeBaked(rows, folder, options.sources, options.mixed);
    if (!options.report.quiet) {
      std::string text;
      for (const std::string& file : merge.written) text += file + "\n";
      printResult(text + folder + ": " + std::to_string(merge.written.size()) + " file(s) taken over, " +
                  std::to_string(merge.removed) + " of earlier bounces removed\n");
    }
  }
  requireBaked(rows, options.bounce, folder);
  if (options.check && !options.report.quiet)
    printResult(folder + ": all of " + std::to_string(rows.size()) + " baked probe(s) done\n");
  return true;
}

/// The bake as a script for others.
std::string scriptOf(const BakeOptions& options, const std::vector<Probe>& probes, const std::string& folder) {
  namespace fs = std::filesystem;
  constexpr std::size_t kMostShards = 64;
  FarmWork work;
  work.program = programPath().empty() ? "boxprobe" : programPath();
  work.name = work.noun = "bake";
  work.step = "bounce";
  work.words = {"bake", fs::absolute(options.scenePath).string(), "-o", fs::absolute(folder).string()};
  const auto pass = [&work](const char* option, const std::vector<std::string>& values) {
    for (const std::string& value : values) work.words.insert(work.words.end(), {option, value});
  };
  pass("--only", options.patterns);
  pass("--probe", options.probes);
  pass("--set", options.assignments);
  if (options.mixed) work.words.emplace_back("--mixed");
  int bounces = 1;
  for (const Probe& probe : probes) bounces = std::max(bounces, probe.bounces);
  if (bounces > 1) work.steps.clear();
  for (int bounce = 1; bounces > 1 && bounce <= bounces; ++bounce) {
    work.steps.push_back({"--bounce", std::to_string(bounce)});
  }
  work.shares = options.shards > 0 ? options.shards : static_cast<int>(std::min(probes.size(), kMostShards));
  work.shares = std::max(work.shares, 1);
  return farmScript(options.script, work);
}

void runBake(const BakeOptions& options) {
  useLargePages();
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const std::optional<BakeShare> share =
      options.shard.empty() ? mpiShare() : std::optional(parseBakeShare(options.shard));
  const InterruptGuard interrupt;
  LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, interrupt, options.report.quiet);
  const std::vector<Probe> chosen = chooseProbes(loaded.scene, options);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  const std::string folder = options.folder.empty() ? BakeFolder::besideScene(options.scenePath) : options.folder;
  if (!options.script.empty()) return printDocument(scriptOf(options, chosen, folder));  // tabs and all
  interrupt.check();

  OffscreenScene shown({"boxprobe bake", 16, 16, 1, options.report.quiet, false, options.report.offscreen,
                        drawsLittle(1, chosen.size())});
  ShownSettings settings;
  settings.bakedFolder = folder;
  settings.bakeTargets = namesOf(chosen);
  shown.show(loaded.scene, loaded.models, settings);
  if (reportOnly(options, chosen, loaded.scene.lamps, shown, folder)) return;

  requireOutputFolder("-o", folder);
  const std::vector<std::string> probes = share ? probesOfShare(chosen, *share) : namesOf(chosen);
  if (share && !options.mixed) {
    const BakeFolder there(folder);  // looked at once: others write into it
    requireMaker(bakeRows(shown, chosen, there), there, {kProgramName, shown.renderer().rendererName()});
  }
  std::map<std::string, int> earlier;
  if (options.bounce > 0) earlier = limitBounces(loaded.scene, chosen, options.bounce, shown);
  settings.bakeTargets = probes;
  for (const auto& [name, bounce] : earlier) settings.cutShort.push_back(name);
  if (!probes.empty()) shown.show(loaded.scene, loaded.models, settings);
  std::vector<std::string> files;
  if (!probes.empty()) files = bakeProbes(shown, probes, earlier, folder, interrupt, options.report.quiet);
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
    const std::string part =
        share ? " (share " + std::to_string(share->index) + " of " + std::to_string(share->count) + ")" : "";
    printResult(text + folder + ": " + std::to_string(probes.size()) + " baked probe(s)" + part + ", " +
                std::to_string(files.size()) + " file(s) written, " + std::to_string(stats.counters.facesCaptured) +
                " faces captured, " + std::to_string(stats.counters.levelsFiltered) + " levels filtered\n");
  }
}

void addFarmOptions(CLI::App& command, BakeOptions& options) {
  command.add_option("--only", options.patterns, "Only probes whose name matches, as in 'hall*' (repeatable)")
      ->type_name("GLOB")
      ->allow_extra_args(false);
  auto* shard = command.add_option("--shard", options.shard,
                                   "Make share I of N; auto: the place in a Slurm array job, under mpiexec or srun "
                                   "(under mpiexec, auto is the default)");
  shard->type_name("I/N|auto");
  command
      .add_option("--bounce", options.bounce,
                  "Go no further than this bounce; the next one continues from its files (default: all bounces)")
      ->check(CLI::Range(1, kAllBounces).description(""))
      ->type_name("B");
  auto* list = command.add_flag("--list", options.list, "List probes and what of them is done; bake nothing");
  auto* check = command.add_flag("--check", options.check, "Exit status 3, and names, unless all is done");
  auto* merge = command.add_option_function<std::vector<std::string>>(
      "--merge",
      [&options](const std::vector<std::string>& folders) {
        options.merge = true;
        // Without a folder, CLI11 hands over an empty text.
        for (const std::string& folder : folders) {
          if (!folder.empty()) options.sources.push_back(folder);
        }
      },
      "Take over what other folders have, remove files of earlier bounces, check");
  merge->expected(0, -1)->type_name("[DIR ...]");
  auto* emit = command.add_option("--emit", options.script, "Print a script that bakes with many processes");
  emit->check(CLI::IsMember({"slurm", "parallel", "make"}).description(""))->type_name("slurm|parallel|make");
  command.add_option("--shards", options.shards, "Number of shares for --emit (default: one per probe, at most 64)")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->needs(emit);
  command.add_flag("--mixed", options.mixed, "Let files of different renderers and versions stand side by side");
  for (auto* option : {static_cast<CLI::Option*>(list), static_cast<CLI::Option*>(check), merge, emit}) {
    for (auto* other : {static_cast<CLI::Option*>(list), static_cast<CLI::Option*>(check), merge, emit, shard}) {
      if (option != other) option->excludes(other);
    }
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
  addFarmOptions(*command, *options);
  addModelOptions(*command, options->assignments);
  addReportOptions(*command, options->report, "Print the JSON that --stats writes");
  addOffscreenOption(*command, options->report);
  command->footer(
      "Skips probes whose file was made from the same inputs: a second call continues where the first one stopped\nand "
      "does nothing if nothing changed.\nMany processes: --emit, or --shard I/N in each of them, all into one folder "
      "or into several that --merge joins.\nExample:\n  boxprobe bake data/scenes/building.boxprobe.json -o "
      "out/building.probes --stats bake.json");
  return {command, [options] { runBake(*options); }};
}

}  // namespace boxprobe
