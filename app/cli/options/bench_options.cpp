#include "app/cli/options/bench_options.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "app/session/output_check.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/frame/refinement.h"

namespace boxprobe {

namespace {

std::vector<Camera> chosenCameras(const BenchOptions& options, const Scene& scene) {
  std::vector<Camera> cameras;
  for (const std::string& name : listedNames(options.cameras)) cameras.push_back(chooseCamera(scene, name));
  if (!cameras.empty()) return cameras;
  const Camera first = chooseCamera(scene, "");
  cameras.push_back(first);
  for (const Camera& camera : scene.cameras) {
    if (!options.quick && !(camera == first)) cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace

std::vector<std::string> listedNames(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

std::vector<double> chosenRoughnesses(const std::string& list) {
  std::vector<double> values;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) {
    double value = 0.0;
    char rest = 0;
    if (std::sscanf(word.c_str(), "%lf%c", &value, &rest) != 1 || !(value >= 0.0 && value <= 1.0)) {
      throw InputError("--roughness " + list + ": expected numbers from 0 to 1 separated by commas, as in 0.1,0.5");
    }
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

void requireBenchFolder(const std::string& folder, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError("-o " + folder + ": this is a file; -o names a folder");
  }
  fs::create_directories(folder, error);
  if (error) throw InputError("-o " + folder + ": cannot create this folder: " + error.message());
  requireWritable("-o", folder + "/" + file);
}

void addBenchOptions(CLI::App& command, BenchOptions& options) {
  command.add_option(
      "SCENE", options.scenePath,
      "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp); default: the gallery scene");
  command.add_option("-o,--output", options.folder, "Folder for bench.json, bench.csv, report.md and the pictures")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_flag("--quick", options.quick,
                   "Use one camera, three roughnesses, small pictures and few frames; takes under a minute");
  command
      .add_option("--techniques", options.techniques,
                  "Measure only these techniques, separated by commas; parameters as in "
                  "raytraced:samples=16:filtered=true (box and hdrp are always measured)")
      ->type_name("LIST");
  command
      .add_option("--roughness", options.roughnesses,
                  "Roughnesses given to every reflecting material (default 0,0.1,0.25,0.5,0.75,1)")
      ->type_name("LIST");
  command.add_option("--camera", options.cameras, "Use only these cameras; frames are timed through the first")
      ->type_name("NAMES");
  command
      .add_option("--materials", options.materials,
                  "Measure only surfaces of these materials; every reflecting one still gets the roughness")
      ->type_name("NAMES");
  command.add_option("--size", options.size, "Size of the pictures that errors are measured in (default 200x112)")
      ->type_name("WxH");
  command
      .add_option("--rooms", options.rooms,
                  "Number of random rooms judged beside the scene (default 192, with --quick 8; 0: none)")
      ->check(CLI::Range(0, 1000));
  // A flag that may have a value: --truth=FILE.
  command.add_flag(std::string("--truth{") + kOwnTruth + "}", options.truthPath,
                   "Compare references and techniques with pictures of an independent path tracer instead; writes "
                   "truth.json (--truth=FILE: another file of such pictures)");
  command.add_flag("--whole", options.whole,
                   "Compare whole pictures, diffuse light and all, with the path tracer's instead; without SCENE of "
                   "every scene that comes with the program; writes whole.json");
  command
      .add_option("--refine", options.refine,
                  "With --truth: each technique's picture also as it is refined at rest by N rays a pixel")
      ->check(CLI::Range(1, RefineSettings::kMostRays).description(""))
      ->type_name("N");
  command.add_option("--seed", options.seed, "Seed of the references' rays")->capture_default_str();
  command.add_option("--set", options.assignments, "Change a field of the scene first (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addReportOptions(command, options.report, "Print bench.json");
  addOffscreenOption(command, options.report);
  command.footer(
      "Measures every technique at every roughness through every camera against two references: the integral over\nthe "
      "probe's box and the ray-traced scene. Takes some minutes; Ctrl-C keeps partial results as "
      "bench.json.partial.\nExamples:\n  boxprobe bench -o out/bench\n  boxprobe bench "
      "data/scenes/building.boxprobe.json -o out/building --techniques box,hdrp,footprint4 --quick\n  boxprobe bench "
      "--truth --techniques footprint8 -o out/truth");
}

FrameSize timedFrameSize(const BenchOptions& options) {
  return options.quick ? FrameSize{320, 180} : FrameSize{640, 360};
}

BenchPlan benchPlan(const BenchOptions& options, const Scene& scene) {
  BenchPlan plan;
  plan.techniques = chooseBenchTechniques(options.techniques);
  plan.cameras = chosenCameras(options, scene);
  plan.roughnesses = options.roughnesses.empty()
                         ? chosenRoughnesses(options.quick ? "0.1,0.5,1" : "0,0.1,0.25,0.5,0.75,1")
                         : chosenRoughnesses(options.roughnesses);
  if (plan.roughnesses.empty()) throw InputError("--roughness: contains no number");
  const FrameSize size = !options.size.empty() ? parseFrameSize(options.size)
                         : options.quick       ? FrameSize{160, 90}
                                               : FrameSize{200, 112};
  plan.materials = listedNames(options.materials);
  plan.width = size.width;
  plan.height = size.height;
  plan.seed = options.seed;
  plan.boxTruth.seed = hashBits(options.seed);
  // Few large passes: points that are spread evenly gain by being many.
  plan.boxTruth.raysPerPass = options.quick ? 128 : 256;
  plan.boxTruth.standardError = options.quick ? 0.002 : 0.0012;
  plan.boxTruth.leastPasses = 3;
  plan.boxTruth.mostPasses = 16;
  plan.sceneTruth = plan.boxTruth;
  plan.sceneTruth.seed = hashBits(plan.boxTruth.seed);
  plan.sceneTruth.raysPerPass = options.quick ? 48 : 64;
  plan.sceneTruth.standardError = 1.5 * plan.boxTruth.standardError;
  plan.sceneTruth.mostPasses = 12;
  plan.lookupPixels = options.quick ? 8 : 16;
  plan.mostPairs = options.quick ? 3 : 9;
  plan.pairSeconds = options.quick ? 0.1 : 0.6;
  plan.study.rooms = options.rooms.value_or(options.quick ? 8 : 192);
  if (options.quick) plan.study.faceSize = 64, plan.study.rays = 1024;
  return plan;
}

}  // namespace boxprobe
