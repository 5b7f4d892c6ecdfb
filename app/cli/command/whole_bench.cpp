// See whole_bench.h.
#include "app/cli/command/whole_bench.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/progress_line.h"
#include "app/session/valid_json.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/data_folder.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/bench/whole_picture.h"
#include "filters/reference/path/reference_path.h"
#include "filters/reference/study/bench_technique.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> chosenScenes(const BenchOptions& options) {
  if (!options.scenePath.empty()) return {options.scenePath};
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(dataFile("scenes"))) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<Camera> chosenCameras(const BenchOptions& options, const Scene& scene) {
  std::vector<Camera> cameras;
  for (const std::string& name : listedNames(options.cameras)) cameras.push_back(chooseCamera(scene, name));
  if (!cameras.empty()) return cameras;
  if (options.quick || scene.cameras.empty()) return {chooseCamera(scene, "")};
  return scene.cameras;
}

/// The scene as it is comes first: its row has no name of a technique.
std::vector<std::optional<BenchTechnique>> chosenTechniques(const BenchOptions& options) {
  std::vector<std::optional<BenchTechnique>> techniques = {std::nullopt};
  if (options.techniques.empty()) return techniques;
  for (const BenchTechnique& technique : chooseBenchTechniques(options.techniques)) techniques.emplace_back(technique);
  return techniques;
}

}  // namespace

void runWholeBench(const BenchOptions& options) {
  if (options.rooms) throw InputError("--rooms is not for --whole: leave one of them out");
  if (!options.roughnesses.empty()) throw InputError("--roughness is not for --whole: every surface is as it is");
  if (!options.materials.empty()) throw InputError("--materials is not for --whole: every pixel is compared");
  requireBenchFolder(options.folder, "whole.json");
  InterruptGuard interrupt;
  const FrameSize size = parseFrameSize(!options.size.empty() ? options.size : options.quick ? "96x54" : "160x90");
  const auto techniques = chosenTechniques(options);
  const std::vector<std::string> scenes = chosenScenes(options);
  OffscreenScene shown(
      {"boxprobe bench --whole", size.width, size.height, 1, options.report.quiet, false, options.report.offscreen});
  std::vector<WholeRow> rows;
  bool complete = true;
  for (std::size_t s = 0; s < scenes.size() && complete; ++s) {
    const LoadedScene loaded = loadScene(scenes[s], options.assignments);
    const std::string name = fs::path(scenes[s]).stem().stem().string();
    if (!options.report.quiet) printWarnings(loaded.warnings);
    ProgressLine line(name, !options.report.quiet);
    const std::vector<Camera> cameras = chosenCameras(options, loaded.scene);
    const ReferencePath path(loaded.scene, loaded.models, loadSkyImage(loaded.scene));
    const SceneTracer tracer(makeTriangleScene(loaded.scene, loaded.models));
    for (std::size_t c = 0; c < cameras.size() && complete; ++c) {
      PathSettings settings;
      settings.width = size.width;
      settings.height = size.height;
      settings.raysPerPixel = options.quick ? 64 : 512;
      settings.seed = options.seed;
      const ReferencePicture truth = path.render(cameras[c], settings, [&](double done) {
        line.show((static_cast<double>(c) + done) / static_cast<double>(cameras.size()));
        if (!rows.empty()) interrupt.waitForPartialResults();
        return !interrupt.interrupted();
      });
      complete = truth.complete;
      if (!complete) break;
      const std::vector<SeenPoint> seen = seenPoints(loaded.scene, tracer, cameras[c], size.width, size.height);
      for (const auto& technique : techniques) {
        const Scene drawn = technique ? withTechnique(loaded.scene, *technique) : loaded.scene;
        const ShownSettings view{cameras[c]};
        shown.show(drawn, loaded.models, view);
        complete = complete && shown.capture([&](double) { return !interrupt.interrupted(); });
        if (!complete) break;
        constexpr int kSamplesPerPixel = 16;
        const ImageRgbaF picture = shown.renderer().renderLinear(size.width, size.height, kSamplesPerPixel);
        shown.requireHealthy();
        rows.push_back({name, cameras[c].name, technique ? technique->label() : "as it is", "all",
                        partErrors(picture, truth, seen)});
      }
    }
    shown.forget();
  }
  const std::string json = validJson(wholeJson(rows, complete));
  if (!complete) {
    const std::string partial = options.folder + "/whole.json.partial";
    writeTextAtomically(partial, json);
    throw WorkError("interrupted; partial results are in " + partial);
  }
  writeTextAtomically(options.folder + "/whole.json", json);
  if (options.report.json) {
    printDocument(json);
  } else if (!options.report.quiet) {
    printResult(wholeTable(rows));
    std::printf("%s/whole.json\n", options.folder.c_str());
  }
}

}  // namespace boxprobe
