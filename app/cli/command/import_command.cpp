// See import_command.h.
#include "app/cli/command/import_command.h"

#include <memory>

#include "app/session/messages.h"
#include "app/session/output_check.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/engines/probe_import.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

struct ImportOptions {
  std::string file, output, model;
  ReportOptions report;
};

void runImport(const ImportOptions& options) {
  if (options.output.empty()) throw InputError("-o is missing: name a scene file to write, NAME.boxprobe.json");
  requireExtension("-o", options.output, {".json"});
  requireWritable("-o", options.output);
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  const ImportedProbes imported = importProbes(options.file);
  Scene scene;
  if (!options.model.empty()) {
    ModelFile model;
    model.file = options.model;
    scene.models.push_back(model);
  }
  scene.probes = imported.probes;
  try {
    validate(scene);
  } catch (const InputError& error) {
    throw InputError(options.file + ": " + error.what());
  }
  saveSceneFile(scene, options.output);
  if (!options.report.quiet) printWarnings(imported.remarks);
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(RunStats{}));
  if (options.report.json) {
    nlohmann::json names = nlohmann::json::array();
    for (const Probe& probe : scene.probes) names.push_back(probe.name);
    const nlohmann::json report = {
        {"engine", imported.engine}, {"probes", names}, {"file", options.output}, {"leftOut", imported.remarks}};
    printDocument(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  } else if (!options.report.quiet) {
    printResult(options.output + ": " + std::to_string(scene.probes.size()) + " probe(s) from " + imported.engine +
                "\n");
  }
}

}  // namespace

Subcommand addImportCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("import", "Make a scene file from the probes of a Unity or Godot scene");
  const auto options = std::make_shared<ImportOptions>();
  command
      ->add_option("FILE", options->file,
                   "Unity scene or prefab (.unity, .prefab as text), Godot scene (.tscn), or a probe's .json of export")
      ->required();
  command->add_option("-o,--output", options->output, "Scene file to write (NAME.boxprobe.json)")->type_name("SCENE");
  command->add_option("--model", options->model, "Model of the scene, as exported from the engine (.glb, .gltf, ...)")
      ->type_name("FILE");
  addReportOptions(*command, options->report, "Print what was imported as JSON");
  command->footer(
      "Reads what has an equivalent and names the rest; x of Unity's positions is negated, as glTF exporters do.\n"
      "Example:\n  boxprobe import Room.tscn -o room.boxprobe.json --model room.glb");
  return {command, [options] { runImport(*options); }};
}

}  // namespace boxprobe
