// See export_command.h.
#include "app/cli/command/export_command.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "app/session/glb_export.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/opened_glb.h"
#include "app/session/output_check.h"
#include "app/session/probe_captures.h"
#include "app/session/program_name.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"
#include "app/web/web_folder.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/core/base/nearest_name.h"
#include "filters/io/engines/export_names.h"
#include "filters/io/engines/ladder.h"
#include "filters/io/engines/technique_text.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

struct ExportOptions {
  std::string scenePath;
  std::string output;  ///< a folder; of --shader a file
  ExportSettings settings;
  std::string shader;     ///< language; empty: pictures are exported
  std::string technique;  ///< of --shader; empty: the first probe's
  std::vector<std::string> probes;
  std::vector<std::string> assignments;
  bool watch = false;
  ReportOptions report;
};

const std::map<std::string, ShaderLanguage>& shaderLanguages() {
  static const std::map<std::string, ShaderLanguage> languages = {
      {"glsl", ShaderLanguage::Glsl}, {"hlsl", ShaderLanguage::Hlsl}, {"godot", ShaderLanguage::Godot}};
  return languages;
}

std::vector<std::string> probesToExport(const Scene& scene, const std::vector<std::string>& wanted) {
  std::vector<std::string> all;
  for (const Probe& probe : scene.probes) all.push_back(probe.name);
  if (all.empty()) throw InputError("the scene has no probes to export; add one, or see boxprobe fit --help");
  for (const std::string& name : wanted) {
    if (findProbe(scene, name)) continue;
    throw InputError("--probe " + name + ": the scene has no such probe; there are: " + nameList(all));
  }
  return wanted.empty() ? all : wanted;
}

void finish(const ExportOptions& options, const std::vector<std::string>& files, const RunStats& stats) {
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
  if (options.report.json) {
    const nlohmann::json report = {{"files", files}};
    printDocument(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  } else if (!options.report.quiet) {
    for (const std::string& file : files) printResult(file + "\n");
  }
}

void runShader(const ExportOptions& options, const LoadedScene& loaded, const std::vector<std::string>& names) {
  const Scene& scene = loaded.scene;
  std::vector<Probe> probes;
  for (const std::string& name : names) probes.push_back(scene.probes[*findProbe(scene, name)]);
  const std::string technique = options.technique.empty() ? probes.front().technique : options.technique;
  // The lamps that lattices leave out, which are the probes' own: any other's light is in the nodes.
  std::vector<SceneLamp> lamps;
  if (scene.lamps == LampForm::Shapes) {
    const SceneLamps all = sceneLamps(scene, loaded.models);
    std::set<std::size_t> own;
    for (const Probe& probe : probes) {
      if (!probe.hasLattice()) continue;
      for (const std::size_t lamp : probeLamps(all.lamps, probe)) own.insert(lamp);
    }
    for (const std::size_t lamp : own) lamps.push_back(all.lamps[lamp]);
  }
  writeTextAtomically(options.output,
                      techniqueText(probes, technique, shaderLanguages().at(options.shader), kProgramName, lamps));
  finish(options, {options.output}, {});
}

/// Where engines will look elsewhere than this program, and files that could not be named after their probe.
std::vector<std::string> exportRemarks(const Scene& scene, const std::vector<std::string>& names,
                                       const ExportSettings& settings) {
  std::vector<std::string> remarks;
  const std::string& ladder = settings.ladder;
  const std::vector<std::string> stems = exportStems(names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Probe& probe = scene.probes[*findProbe(scene, names[i])];
    const std::string place = "probes." + names[i];
    if (stems[i] != names[i]) remarks.push_back(place + ": its files are named " + stems[i]);
    const bool oneCenter = ladder == "bevy" || ladder == "babylon";
    if (oneCenter && !settings.center && probe.origin != probe.box.center()) {
      remarks.push_back(place +
                        ".origin: is not the middle of the box, where the engine starts its lookups; --center "
                        "moves the cubemap there");
    }
    if ((ladder == "babylon" || ladder == "unity") && probe.rotationDegrees != glm::dvec3(0.0)) {
      remarks.push_back(place + ".rotationDegrees: the engine's box projection knows no turned box");
    }
  }
  return remarks;
}

// The whole scene, not the pictures of exportFormats().
constexpr const char* kWebFormat = "web";
constexpr const char* kGlbFormat = "glb";

void checkSceneExport(const ExportOptions& options) {
  const auto refuse = [&options](bool given, const std::string& option) {
    if (!given) return;
    throw InputError(option + ": --format " + options.settings.format +
                     " writes the whole scene as it is; leave it out");
  };
  refuse(!options.probes.empty() && options.settings.format == kWebFormat, "--probe");
  refuse(options.settings.center, "--center");
  refuse(options.settings.lossy, "--lossy");
  refuse(options.settings.ladder != "own", "--ladder " + options.settings.ladder);
  ExportSettings sizes;
  sizes.faceSize = options.settings.faceSize;
  checkExportSettings(sizes);
}

std::vector<std::string> exportWeb(const ExportOptions& options, const LoadedScene& loaded,
                                   const CapturedProbes& captured) {
  Scene shown = loaded.scene;
  if (shown.cameras.empty()) shown.cameras.emplace_back();  // as `render` looks at it
  const WebScene scene = webScene(shown, loaded.models, captured.captures, options.settings.faceSize, kProgramName);
  if (!options.report.quiet) printWarnings(scene.remarks);
  return writeWebFolder(scene, sceneName(options.scenePath), options.output);
}

/// The .glb that -o names, or the one in the folder that it names.
std::string glbPath(const ExportOptions& options) {
  if (lowerExtension(options.output) == ".glb") return options.output;
  return (std::filesystem::path(options.output) / (sceneName(options.scenePath) + ".glb")).string();
}

using FileStamps = std::map<std::string, FileStamp>;

/// What the export of a scene depends on: `asked` for its models, and what is read when it is drawn.
FileStamps filesOf(const std::string& scenePath, const Scene& scene, FileStamps asked) {
  FileStamps files = std::move(asked);
  const auto add = [&files](const std::string& file) {
    if (files.count(file) == 0) files.emplace(file, stampOf(file));
  };
  add(scenePath);
  for (const ModelFile& model : scene.models) add(model.file);
  if (const auto* image = std::get_if<SkyImage>(&scene.sky)) add(image->file);
  for (const Probe& probe : scene.probes) {
    if (!probe.image.empty()) add(probe.image);
  }
  return files;
}

bool anyChanged(const FileStamps& files) {
  return std::any_of(files.begin(), files.end(),
                     [](const auto& file) { return !(stampOf(file.first) == file.second); });
}

/// What stays between the exports of --watch.
struct ExportRun {
  ExportOptions options;
  const InterruptGuard& interrupt;
  std::unique_ptr<GlbExporter> glb;
  FileStamps read;        ///< files that the last export was made of, as they were before they were read
  int revision = 0;       ///< of the file, with --watch
  bool exported = false;  ///< at least once
};

void exportGlb(ExportRun& run, LoadedScene& loaded, const std::vector<std::string>& names) {
  const ExportOptions& options = run.options;
  auto& probes = loaded.scene.probes;
  probes.erase(std::remove_if(probes.begin(), probes.end(),
                              [&names](const Probe& probe) {
                                return std::find(names.begin(), names.end(), probe.name) == names.end();
                              }),
               probes.end());
  const std::string path = glbPath(options);
  if (!run.glb) {
    run.glb = std::make_unique<GlbExporter>(
        GlbWishes{path, bakedFolderOf(options.scenePath), options.report.offscreen, options.report.quiet});
  }
  // Boxes first: who follows the file sees them before anything is captured.
  if (const std::string quick = run.glb->bytesOfBefore(loaded); !quick.empty()) {
    writeTextAtomically(path, quick);
    writeRevision(path, ++run.revision);
  }
  writeTextAtomically(path, run.glb->bytes(loaded, run.interrupt));
  finish(options, {path}, run.glb->stats());
}

/// Remembers what was read, or asked for where that failed.
LoadedScene loadFollowed(ExportRun& run) {
  const ExportOptions& options = run.options;
  const FilesAsked asked;
  try {
    LoadedScene loaded = loadSceneShown(options.scenePath, options.assignments, run.interrupt, options.report.quiet);
    run.read = filesOf(options.scenePath, loaded.scene, asked.stamps());
    return loaded;
  } catch (const Error&) {
    for (auto& [file, stamp] : run.read) stamp = stampOf(file);
    for (const auto& [file, stamp] : asked.stamps()) run.read[file] = stamp;
    throw;
  }
}

void exportOnce(ExportRun& run) {
  ExportOptions options = run.options;
  const bool shader = !options.shader.empty(), web = !shader && options.settings.format == kWebFormat;
  const bool glb = !shader && options.settings.format == kGlbFormat;
  LoadedScene loaded = loadFollowed(run);
  const std::vector<std::string> names = probesToExport(loaded.scene, options.probes);
  // A size above the capture's is captured; one below is averaged from it, and a baked file serves.
  for (const std::string& name : names) {
    Probe& probe = loaded.scene.probes[*findProbe(loaded.scene, name)];
    if (options.settings.faceSize != 0) probe.faceSize = std::max(probe.faceSize, options.settings.faceSize);
    if ((shader || glb) && options.settings.faceSize != 0) probe.faceSize = options.settings.faceSize;
  }
  if (shader) return runShader(options, loaded, names);
  if (!glb || glbPath(options) != options.output) requireOutputFolder("-o", options.output);
  if (!options.report.quiet) {
    printWarnings(loaded.warnings);
    if (!web && !glb) printWarnings(exportRemarks(loaded.scene, names, options.settings));
  }
  if (glb) return exportGlb(run, loaded, names);
  const CaptureWishes wishes = {names, bakedFolderOf(options.scenePath), options.report.offscreen,
                                options.report.quiet};
  const CapturedProbes captured = captureProbes(loaded, wishes, run.interrupt);
  if (web) return finish(options, exportWeb(options, loaded, captured), captured.stats);
  ProgressLine line("filtering", !options.report.quiet);
  options.settings.writer = kProgramName;
  const std::vector<std::string> files =
      exportProbes(captured.captures, options.settings, options.output, [&](double fraction) {
        line.show(fraction);
        return !run.interrupt.interrupted();
      });
  run.interrupt.check();
  finish(options, files, captured.stats);
}

/// Exports again when a file that the export was made of changes, until Ctrl-C.
void watch(ExportRun& run) {
  using namespace std::chrono_literals;
  const bool glb = run.options.shader.empty() && run.options.settings.format == kGlbFormat;
  const std::string output = glb ? glbPath(run.options) : run.options.output;
  run.revision = lastRevision(output);  // who followed an earlier run waits for a higher one
  for (bool due = true; !run.interrupt.interrupted(); due = anyChanged(run.read)) {
    if (!due) {
      std::this_thread::sleep_for(50ms);
      continue;
    }
    try {
      exportOnce(run);
      writeRevision(output, ++run.revision);
      run.exported = true;
    } catch (const Error& error) {
      if (run.interrupt.interrupted()) break;
      if (!run.exported) throw;  // the scene has never been right
      printWarnings({std::string(error.what()) + "; what was written before stays"});
    }
  }
}

void runExport(const ExportOptions& options) {
  if (options.output.empty()) throw InputError("-o is missing: name a folder, or a file with --shader or --format glb");
  const bool shader = !options.shader.empty();
  const bool web = options.settings.format == kWebFormat, glb = options.settings.format == kGlbFormat;
  if (shader) {
    if (shaderLanguages().count(options.shader) == 0) {
      throw InputError("--shader " + options.shader + ": no such language; there are: glsl, hlsl, godot");
    }
    requireWritable("-o", options.output);
  } else {
    if (!options.technique.empty()) throw InputError("--technique belongs to --shader; pictures have none");
    web || glb ? checkSceneExport(options) : checkExportSettings(options.settings);
  }
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const bool glbFile = !shader && glb && glbPath(options) == options.output;
  if (!shader && glb) {
    if (!glbFile) requireOutputFolder("-o", options.output);
    requireWritable("-o", glbPath(options));  // and no file that is read
  }
  const InterruptGuard interrupt;
  ExportRun run{options, interrupt, nullptr, {}, 0, false};
  options.watch ? watch(run) : exportOnce(run);
}

std::string ladderHelp() {
  std::string text = "Roughness of each level and axes of the cube, as an engine has them:";
  for (const LadderRow& row : ladderRows()) text += "\n" + std::string(row.id) + ": " + std::string(row.help);
  return text;
}

}  // namespace

Subcommand addExportCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("export", "Write probes, or a technique's shader, for another program");
  const auto options = std::make_shared<ExportOptions>();
  command
      ->add_option("SCENE", options->scenePath,
                   "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Folder for the files; with --shader, the file; with --format glb, either")
      ->type_name("DIR");
  command
      ->add_option("--format", options->settings.format,
                   "ktx2 or dds: cube of half floats with all levels; exr or hdr: latitude-longitude, level 0; web: a "
                   "folder for a web server that draws the scene; glb: the model with its probes inside, one file")
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_option("--ladder", options->settings.ladder, ladderHelp())->type_name("LADDER")->capture_default_str();
  command
      ->add_option("--size", options->settings.faceSize,
                   "Texels along a face of level 0, a power of two (default: the probe's faceSize)")
      ->type_name("N");
  command->add_flag("--center", options->settings.center,
                    "Move the cubemap's origin to the middle of the box, through the box: for engines that know no "
                    "other origin");
  command->add_flag("--lossy", options->settings.lossy,
                    "Write values that the format cannot hold as the nearest that it can");
  command->add_option("--shader", options->shader, "Write a technique as a function instead: glsl, hlsl or godot")
      ->type_name("LANGUAGE");
  command->add_option("--technique", options->technique, "Technique of --shader (default: the first probe's)")
      ->type_name("ID");
  command->add_flag("--watch", options->watch,
                    "Export again whenever the scene, its models or what these name is saved, until Ctrl-C. Each "
                    "export increments the number in "
                    "FILE.revision or DIR/revision.");
  command->add_option("--probe", options->probes, "Export only this probe (repeatable; default: all)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--set", options->assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(*command, options->assignments);
  addReportOptions(*command, options->report, "Print the names of the files as JSON");
  addOffscreenOption(*command, options->report);
  command->footer(
      "Beside each picture stands NAME.json (box, origin, rotation, influence, blend, levels), and the file that takes "
      "both into\nthe engine. Examples:\n"
      "  boxprobe export data/scenes/room.boxprobe.json -o out/room --format ktx2 --ladder three\n"
      "  boxprobe export data/scenes/room.boxprobe.json -o out/room --format dds --ladder babylon --size 128 --center\n"
      "  boxprobe export data/scenes/room.boxprobe.json -o out/viewer --format web\n"
      "  boxprobe export data/scenes/room.boxprobe.json -o out/room.glb --format glb\n"
      "  boxprobe export data/scenes/room.boxprobe.json -o out/room.glsl --shader glsl --technique box+footprint4");
  return {command, [options] { runExport(*options); }};
}

}  // namespace boxprobe
