// See truth_bench.h.
#include "app/cli/command/truth_bench.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <tuple>
#include <utility>

#include "app/session/interrupt.h"
#include "app/session/messages.h"
#include "app/session/offscreen_scene.h"
#include "app/session/progress_line.h"
#include "app/session/truth_stage.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/data_folder.h"
#include "filters/reference/truth/truth_trace.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// Nothing where it does not name a scene of the truth pictures.
std::string truthSceneName(const TruthIndex& index, const std::string& path) {
  std::error_code error;
  for (const TruthPicture& picture : index.pictures) {
    if (fs::equivalent(index.scenePath(picture.scene), path, error)) return picture.scene;
  }
  return {};
}

std::vector<const TruthPicture*> chosenPictures(const TruthIndex& index, const BenchOptions& options) {
  std::string scene;
  if (!options.scenePath.empty()) {
    scene = truthSceneName(index, options.scenePath);
    if (scene.empty()) {
      throw InputError(options.scenePath +
                       ": there are no truth pictures of this scene; leave it out, or name one of " + index.folder +
                       "/scenes");
    }
  }
  const std::vector<double> roughnesses = chosenRoughnesses(options.roughnesses);
  const std::vector<std::string> cameras = listedNames(options.cameras);
  std::vector<const TruthPicture*> chosen;
  for (const TruthPicture& picture : index.pictures) {
    const auto listed = [](const auto& list, const auto& value) {
      return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
    };
    if (picture.whole || (!scene.empty() && picture.scene != scene)) continue;
    if (options.quick && picture.kind == "coat") continue;
    if (!listed(roughnesses, picture.roughness) || !listed(cameras, picture.camera)) continue;
    chosen.push_back(&picture);
  }
  if (chosen.empty()) throw InputError("bench --truth: no truth picture has such a camera and roughness");
  // Pictures of one scene and floor follow each other: nothing is captured or compiled again between cameras.
  std::stable_sort(chosen.begin(), chosen.end(), [](const TruthPicture* a, const TruthPicture* b) {
    return std::tie(a->scene, a->kind, a->roughness) < std::tie(b->scene, b->kind, b->roughness);
  });
  return chosen;
}

}  // namespace

void runTruthBench(const BenchOptions& options) {
  if (!options.size.empty()) throw InputError("--size is not for --truth: the truth pictures have their own size");
  if (!options.materials.empty())
    throw InputError("--materials is not for --truth: every reflecting pixel is compared");
  if (options.rooms) throw InputError("--rooms is not for --truth: leave one of them out");
  for (const std::string& assignment : options.assignments) {
    if (assignment.rfind("lamps=", 0) == 0) continue;  // how they are drawn
    throw InputError("--set is not for --truth, but for lamps: the truth pictures are of scenes as they are");
  }
  InterruptGuard interrupt;
  const TruthIndex index =
      loadTruthIndex(options.truthPath == kOwnTruth ? dataFile("truth/truth.json") : options.truthPath);
  const std::vector<const TruthPicture*> pictures = chosenPictures(index, options);
  const std::vector<BenchTechnique> techniques = chooseBenchTechniques(options.techniques);
  requireBenchFolder(options.folder, "truth.json");
  OffscreenScene shown({"boxprobe bench --truth", kTruthFineness * index.width, kTruthFineness * index.height, 1,
                        options.report.quiet, false, options.report.offscreen});
  const TruthEffort effort{options.quick ? 256 : 512, options.quick ? 4 : 1};
  std::vector<TruthRow> rows;
  bool complete = true;
  try {
    ProgressLine line("comparing", !options.report.quiet);
    const ReferenceProgress going = [&](double) { return !interrupt.interrupted(); };
    std::unique_ptr<TruthStage> stage;
    const auto add = [&](TruthRow row) {
      rows.push_back(std::move(row));
      interrupt.waitForPartialResults();
      line.show(static_cast<double>(rows.size()) / static_cast<double>(pictures.size() * (techniques.size() + 1)));
      if (interrupt.interrupted()) throw TruthStage::Stopped();
    };
    const TruthPicture* last = nullptr;
    for (const TruthPicture* picture : pictures) {
      if (last == nullptr || last->scene != picture->scene) {
        stage = std::make_unique<TruthStage>(index, picture->scene, shown, going, options.assignments);
      }
      if (last == nullptr || last->scene != picture->scene || last->kind != picture->kind ||
          last->roughness != picture->roughness) {
        stage->setFloor(*picture);
      }
      last = picture;
      add(stage->sceneRow(*picture, effort));
      if (index.isBox(picture->scene)) add(stage->boxRow(*picture, effort));
      for (const BenchTechnique& technique : techniques) {
        add(stage->techniqueRow(*picture, technique));
        if (options.refine > 0) add(stage->refinedRow(*picture, technique, options.refine));
      }
    }
  } catch (const TruthStage::Stopped&) {
    complete = false;
  }
  std::stable_sort(rows.begin(), rows.end(), [](const TruthRow& a, const TruthRow& b) {
    return std::make_tuple(!a.reference(), a.scene) < std::make_tuple(!b.reference(), b.scene);
  });
  const std::string json = truthJson(index, rows, complete);
  if (!complete) {
    const std::string partial = options.folder + "/truth.json.partial";
    writeTextAtomically(partial, json);
    throw WorkError("interrupted; partial results are in " + partial);
  }
  writeTextAtomically(options.folder + "/truth.json", json);
  if (options.report.json) {
    printDocument(json);
  } else if (!options.report.quiet) {
    printResult(truthTable(index, rows));
    std::printf("%s/truth.json\n", options.folder.c_str());
  }
}

}  // namespace boxprobe
