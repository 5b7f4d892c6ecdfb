#include "filters/vtk/probes/capture_inputs.h"

#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

std::string lampsKey(const SceneLamps& lamps) {
  ContentHash hash;
  hash.add("lamps as shapes, in rough reflections too");
  for (const SceneLamp& lamp : lamps.lamps) {
    hash.add(static_cast<double>(lamp.corners.size())).add(lamp.bothSides ? 1 : 0).addVector(lamp.radiance);
    for (const glm::dvec3& corner : lamp.corners) hash.addVector(corner);
  }
  return hash.text();
}

}  // namespace

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
  return world;
}

}  // namespace boxprobe
