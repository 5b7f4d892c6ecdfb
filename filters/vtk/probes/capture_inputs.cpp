#include "filters/vtk/probes/capture_inputs.h"

#include <algorithm>

#include "filters/core/geometry/model_placement.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

std::string lampsKey(const SceneLamps& lamps) {
  ContentHash hash;
  hash.add("lamps as shapes");
  for (const SceneLamp& lamp : lamps.lamps) {
    hash.add(static_cast<double>(lamp.corners.size())).add(lamp.bothSides ? 1 : 0).addVector(lamp.radiance);
    for (const glm::dvec3& corner : lamp.corners) hash.addVector(corner);
  }
  return hash.text();
}

}  // namespace

// Anything that stands still may throw a lamp's shadow into a capture, whether the capture shows it or not.
std::string CaptureInputs::hidingKey(const SceneContent& content) {
  const bool same = std::equal(content.given.begin(), content.given.end(), hidingModels_.begin(), hidingModels_.end(),
                               [](const auto& now, const auto& before) { return now == before.lock(); });
  if (!same || hidingKey_.empty()) {
    hidingModels_.assign(content.given.begin(), content.given.end());
    ContentHash hash;
    for (const std::string& key : objectContentKeys(content.given, content.scene.models.size())) hash.add(key);
    hidingKey_ = hash.text();
  }
  ContentHash hash;
  hash.add(hidingKey_);
  for (const ModelFile& file : content.scene.models) {
    const glm::dmat4 placed = worldFromFile(file);
    hash.addBytes(&placed, sizeof placed);
  }
  for (const auto& [node, object] : content.scene.objects) {
    hash.add(node).add(object.visible ? 1 : 0).add(object.dynamic ? 1 : 0);
    if (!object.dynamic) hash.addVector(object.translation).addVector(object.rotationDegrees);
  }
  return hash.text();
}

CaptureWorld CaptureInputs::world(const SceneContent& content, const ProbeIndex& probes) {
  if (contentGeneration_ != content.modelGeneration) {
    contentKeys_ = objectContentKeys(content.models, content.scene.models.size());
    contentGeneration_ = content.modelGeneration;
  }
  if (content.skyImage != skyImage_.lock()) {
    skyImage_ = content.skyImage;
    skyPixels_ = content.skyImage ? imageContentKey(*content.skyImage) : std::string();
  }
  std::vector<PlacedObject> objects;
  objects.reserve(content.objects.size());
  for (const DrawnObject& drawn : content.objects) {
    PlacedObject object;
    object.node = drawn.node;
    object.materialName = drawn.materialName;
    object.contentKey = contentKeys_[objects.size()];
    object.worldFromModel = drawn.worldFromModel;
    object.boundsWorld = worldBounds(drawn);
    object.seenByProbes = drawn.settings.seenByProbes;
    object.dynamic = drawn.settings.dynamic;
    object.unlit = drawn.unlit;
    objects.push_back(std::move(object));
  }
  CaptureWorld world = captureWorld(content.scene, objects, skyPixels_, probes);
  // Lamps drawn as shapes light what a capture shows, those that it does not show included.
  if (content.lamps) world.lights += " " + lampsKey(*content.lamps);
  if (content.lamps && content.sightLines) world.lights += " shadowed " + hidingKey(content);
  return world;
}

}  // namespace boxprobe
