#include "filters/vtk/capture_key.h"

#include <iomanip>
#include <sstream>

namespace boxprobe {

namespace {

class KeyText {
 public:
  KeyText() { text_ << std::setprecision(17); }
  KeyText& add(double value) {
    text_ << value << ' ';
    return *this;
  }
  KeyText& add(const std::string& value) {
    text_ << value.size() << ':' << value << ' ';
    return *this;
  }
  template <typename Vector>
  KeyText& addVector(const Vector& v) {
    return add(v.x).add(v.y).add(v.z);
  }
  std::string str() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

std::string ownKey(const Probe& probe) {
  KeyText key;
  key.addVector(probe.origin).add(probe.nearDistance).add(probe.farDistance).add(probe.faceSize).add(probe.bounces);
  key.add(probe.samplesPerPixel).add(static_cast<double>(probe.filter)).add(static_cast<double>(probe.clear.index()));
  if (const auto* color = std::get_if<glm::vec3>(&probe.clear)) key.addVector(*color);
  for (const std::string& node : probe.hides) key.add(node);
  return key.str();
}

}  // namespace

std::string skyKey(const Scene& scene) {
  KeyText key;
  key.add(static_cast<double>(scene.sky.index()));
  if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) {
    key.addVector(gradient->top).addVector(gradient->horizon).addVector(gradient->ground);
  } else if (const auto* color = std::get_if<SkyColor>(&scene.sky)) {
    key.addVector(color->color);
  } else {
    key.add(std::get<SkyImage>(scene.sky).file);
  }
  return "sky " + key.str();
}

std::string sharedCaptureKey(const Scene& scene, const std::vector<DrawnObject>& objects, int modelGeneration) {
  KeyText key;
  key.add(modelGeneration).add(skyKey(scene));
  for (const Light& light : scene.lights) {
    key.add(static_cast<double>(light.type)).addVector(light.direction).addVector(light.position);
    key.addVector(light.color).add(light.intensity);
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].settings.seenByProbes) continue;
    key.add(static_cast<double>(i));
    const auto it = scene.materials.find(objects[i].materialName);
    if (it == scene.materials.end()) continue;
    const MaterialOverride& m = it->second;
    key.add(it->first);
    for (const auto& color : {m.baseColor, m.emissive}) {
      if (color) key.addVector(*color);
      key.add(color ? 1 : 0);
    }
    for (const auto& value : {m.metallic, m.roughness, m.normalScale, m.coat, m.ior, m.transmission}) {
      key.add(value ? *value : -1.0);
    }
  }
  return key.str();
}

std::string captureKey(const Scene& scene, std::size_t probe, const std::vector<bool>& used,
                       const std::string& shared) {
  std::string key = ownKey(scene.probes[probe]) + "| " + shared;
  if (scene.probes[probe].bounces > 1) {
    for (std::size_t i = 0; i < scene.probes.size(); ++i) {
      if (i != probe && used[i]) key += "| " + ownKey(scene.probes[i]);
    }
  }
  return key;
}

}  // namespace boxprobe
