#include "app/session/truth_stage.h"

#include <utility>

#include "app/session/offscreen_scene.h"
#include "app/session/reference_box_picture.h"
#include "filters/core/base/errors.h"
#include "filters/reference/bench/bench_surfaces.h"

namespace boxprobe {

TruthStage::TruthStage(const TruthIndex& index, const std::string& scene, OffscreenScene& shown,
                       ReferenceProgress progress, const std::vector<std::string>& assignments)
    : index_(index),
      loaded_(loadScene(index.scenePath(scene), assignments)),
      sky_(loadSkyImage(loaded_.scene)),
      shown_(shown),
      progress_(std::move(progress)) {}

void TruthStage::setFloor(const TruthPicture& picture) {
  scene_ = withTruthFloor(loaded_.scene, picture);
  models_ = withTruthFloor(loaded_.models, picture);
  reference_ = reference_ ? std::make_unique<ReferenceScene>(scene_, models_, *reference_)
                          : std::make_unique<ReferenceScene>(scene_, models_, sky_);
}

const Camera& TruthStage::camera(const std::string& name) const {
  for (const Camera& c : loaded_.scene.cameras) {
    if (c.name == name) return c;
  }
  throw InputError(loaded_.path + ": has no camera " + name + ", which the truth pictures were made with");
}

TruthRow TruthStage::sceneRow(const TruthPicture& picture, const TruthEffort& effort) const {
  const Camera& from = camera(picture.camera);
  const ReferencePicture traced = traceTruth(*reference_, index_, picture, from, effort, progress_);
  if (!traced.complete) throw Stopped();
  return compareWithTruth(index_, picture, from, "reference-scene", traced.color, &traced.standardError);
}

TruthRow TruthStage::boxRow(const TruthPicture& picture, const TruthEffort& effort) {
  if (maps_.probes.empty()) {
    maps_ = captured(kBoxFaceSize);
    coarseMaps_ = captured(kBoxFaceSize / 2);
  }
  const Camera& from = camera(picture.camera);
  const auto integrated = [&](const ReferenceBoxMaps& maps) {
    return integrateTruth(*reference_, loaded_.scene.probes.at(0), maps, index_, picture, from, effort, progress_);
  };
  const ReferencePicture made = integrated(maps_), coarser = integrated(coarseMaps_);
  if (!made.complete || !coarser.complete) throw Stopped();
  TruthRow row = compareWithTruth(index_, picture, from, "reference-box", made.color, &made.standardError);
  row.texelCost = texelCost(made, coarser, loadTruthPicture(index_, picture));
  return row;
}

TruthRow TruthStage::techniqueRow(const TruthPicture& picture, const BenchTechnique& technique) {
  const Camera& from = camera(picture.camera);
  shown_.show(withTechnique(scene_, technique), models_, {from});
  captureShown();
  const ImageRgbaF fine =
      shown_.renderer().renderLinear(kTruthFineness * index_.width, kTruthFineness * index_.height, 4);
  shown_.requireHealthy();
  return compareWithTruth(index_, picture, from, technique.label(), boxAveraged(fine, kTruthFineness));
}

TruthRow TruthStage::refinedRow(const TruthPicture& picture, const BenchTechnique& technique, int rays, double* left) {
  // A mirror's picture is as sharp as its pixels.
  const bool mirror = picture.roughness == 0.0;
  const int fineness = mirror ? kTruthFineness : 2, samples = mirror ? 4 : 1;
  const Camera& from = camera(picture.camera);
  shown_.show(withTechnique(scene_, technique), models_, {from});
  SceneRenderer& renderer = shown_.renderer();
  if (rays <= 0) {
    captureShown();
    const ImageRgbaF own = renderer.renderLinear(fineness * index_.width, fineness * index_.height, samples);
    shown_.requireHealthy();
    return compareWithTruth(index_, picture, from, technique.label(), boxAveraged(own, fineness));
  }
  RefineSettings settings;
  settings.rays = rays;
  renderer.refine(settings);
  captureShown();
  renderer.sharpenMirrors(fineness * index_.height);
  captureShown();
  const ImageRgbaF fine = renderer.renderRefined(fineness * index_.width, fineness * index_.height, samples, settings);
  if (left != nullptr) *left = renderer.refineState().left;
  renderer.refine({});
  renderer.sharpenMirrors(0);
  shown_.requireHealthy();
  return compareWithTruth(index_, picture, from, technique.label() + " refined " + std::to_string(rays),
                          boxAveraged(fine, fineness));
}

void TruthStage::captureShown() {
  bool going = true;
  shown_.capture([&](double share) { return going = !progress_ || progress_(share); });
  if (!going) throw Stopped();
}

ReferenceBoxMaps TruthStage::captured(int faceSize) {
  Scene scene = loaded_.scene;
  for (Probe& probe : scene.probes) {
    probe.faceSize = faceSize;
    probe.samplesPerPixel = 16;
    probe.filterSamples = 8;  // rough levels are not read
  }
  shown_.show(scene, loaded_.models);
  captureShown();
  shown_.requireHealthy();
  return boxMaps(shown_.renderer(), scene);
}

}  // namespace boxprobe
