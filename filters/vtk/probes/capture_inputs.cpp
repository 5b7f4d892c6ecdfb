#include "filters/vtk/probes/capture_inputs.h"

namespace boxprobe {

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
  return captureWorld(content.scene, objects, skyPixels_, probes);
}

}  // namespace boxprobe
