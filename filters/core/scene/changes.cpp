// Which kinds of value differ between two scenes; see document.h. A field that is added to Probe belongs in exactly one
// of the three groups below, by what it costs to show it.
#include <tuple>
#include <unordered_map>

#include "filters/core/scene/document.h"

namespace boxprobe {

namespace {

/// Shown by new uniforms.
auto shapeFields(const Probe& p) {
  return std::tie(p.box, p.influence, p.rotationDegrees, p.blendDistance, p.intensity, p.importance, p.bevel,
                  p.occlusion);
}

/// Shown by another program, perhaps.
auto techniqueFields(const Probe& p) {
  return std::tie(p.technique, p.parameters, p.projection);
}

/// Shown by a new capture or filtering.
auto captureFields(const Probe& p) {
  return std::tie(p.origin, p.rotationDegrees, p.nearDistance, p.farDistance, p.clear, p.faceSize, p.bounces, p.mode,
                  p.image, p.imageLayout, p.encoding, p.decode, p.filter, p.samplesPerPixel, p.filterSamples, p.hides);
}

void compare(Changes& changes, const Probe& before, const Probe& after) {
  changes.probeShape |= shapeFields(before) != shapeFields(after);
  changes.probeTechnique |= techniqueFields(before) != techniqueFields(after);
  changes.probeCapture |= captureFields(before) != captureFields(after);
}

void compareProbes(Changes& changes, const std::vector<Probe>& before, const std::vector<Probe>& after) {
  bool sameList = before.size() == after.size();
  for (std::size_t i = 0; sameList && i < before.size(); ++i) sameList = before[i].name == after[i].name;
  if (sameList) {
    for (std::size_t i = 0; i < before.size(); ++i) compare(changes, before[i], after[i]);
    return;
  }
  changes.probeList = true;
  std::unordered_map<std::string, const Probe*> byName;
  for (const Probe& probe : before) byName.emplace(probe.name, &probe);
  for (const Probe& probe : after) {
    const auto found = byName.find(probe.name);
    if (found != byName.end()) compare(changes, *found->second, probe);
  }
}

}  // namespace

bool Changes::any() const {
  return probeShape || probeTechnique || probeCapture || probeList || materials || objects || lights || sky || models ||
         cameras || exposure || selection || file;
}

Changes& Changes::operator|=(const Changes& other) {
  probeShape |= other.probeShape;
  probeTechnique |= other.probeTechnique;
  probeCapture |= other.probeCapture;
  probeList |= other.probeList;
  materials |= other.materials;
  objects |= other.objects;
  lights |= other.lights;
  sky |= other.sky;
  models |= other.models;
  cameras |= other.cameras;
  exposure |= other.exposure;
  selection |= other.selection;
  file |= other.file;
  return *this;
}

Changes Changes::all() {
  Changes changes;
  changes.probeShape = changes.probeTechnique = changes.probeCapture = changes.probeList = true;
  changes.materials = changes.objects = changes.lights = changes.sky = changes.models = true;
  changes.cameras = changes.exposure = changes.selection = changes.file = true;
  return changes;
}

Changes difference(const Scene& before, const Scene& after) {
  Changes changes;
  if (&before == &after) return changes;
  compareProbes(changes, before.probes, after.probes);
  changes.materials = before.materials != after.materials;
  changes.objects =
      before.objects != after.objects || before.mirrors != after.mirrors || before.mirrorBudget != after.mirrorBudget;
  changes.lights = !(before.lights == after.lights);
  changes.sky = !(before.sky == after.sky) || before.skyRotationDegrees != after.skyRotationDegrees;
  changes.models = !(before.models == after.models);
  changes.cameras = !(before.cameras == after.cameras);
  changes.exposure = before.exposure != after.exposure;
  return changes;
}

}  // namespace boxprobe
