// What a scene asks for that will not show in the picture: features this version accepts without acting on them, and
// names that the models do not have. `info`, rendering (as warnings) and the window show these.
#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "filters/core/base/field_error.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/core/geometry/light_shadow.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_reach.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/technique/automatic.h"

namespace boxprobe {

namespace {

using Remarks = std::vector<std::string>;

void remark(Remarks& remarks, const KeyPath& path, const std::string& sentence) {
  remarks.push_back(oneLine(keyPathText(path) + ": " + sentence));
}

bool flat(const Box& box) {
  return glm::any(glm::equal(box.min, box.max));
}

// Not an error: parameters that one technique does not read are kept for the next, so that trying another loses
// nothing.
void parameterRemarks(Remarks& remarks, const Probe& probe) {
  const Technique technique = probeTechnique(probe);
  std::vector<std::string> names;
  for (const ParameterRow* row : parametersOf(technique)) names.emplace_back(row->name);
  for (const auto& [name, value] : probe.parameters) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    remark(remarks, {"probes", probe.name, "parameters", name},
           "is not used by technique " + techniqueId(technique) + ", whose parameters are: " + nameList(names) + ".");
  }
}

void budgetRemarks(Remarks& remarks, const Probe& probe) {
  const Technique technique = probeTechnique(probe);
  if (!isAutomatic(technique)) return;
  const double budget = parameterNumber(probe, *findParameter("budget"));
  for (const double roughness : measuredRoughness()) {
    const AutomaticChoice choice = chooseAutomatic(roughness, roughness, budget);
    if (choice.withinBudget) continue;
    remark(remarks, {"probes", probe.name, "parameters", "budget"},
           "no technique stays within " + numberText(budget) + " at every roughness; at roughness " +
               numberText(roughness) + " the nearest is " + techniqueId(choice.technique) + " with " +
               numberText(choice.error) + ", which is used.");
    return;
  }
}

void latticeRemarks(Remarks& remarks, const Scene& scene, const Probe& probe) {
  if (!probe.lattice || !probe.lattice->used) return;
  if (scene.lamps == LampForm::InMap) {
    return remark(remarks, {"probes", probe.name, "lattice"},
                  "is not used where lamps are in-map; choose \"lamps\": \"shapes\".");
  }
  const Box& influence = probe.influenceBox();
  const ProbeReach reach = influenceReach(probe.box.min, probe.box.max, influence.min, influence.max);
  const glm::dvec3 steps = (probe.box.size() + reach.low + reach.high) / probe.lattice->spacing;
  const double most = std::max({steps.x, steps.y, steps.z});
  if (std::lround(std::min(most, 1.0e9)) < DiffuseLattice::kMostNodes) return;
  remark(remarks, {"probes", probe.name, "lattice", "spacing"},
         "is " + numberText(probe.lattice->spacing) + ": along an axis there are at most " +
             std::to_string(DiffuseLattice::kMostNodes) + " nodes, so they may be farther apart.");
}

void probeRemarks(Remarks& remarks, const Scene& scene, const Probe& probe) {
  const auto say = [&](const char* key, const std::string& sentence) {
    remark(remarks, {"probes", probe.name, key}, sentence);
  };
  if (flat(probe.box)) say("box", "is flat: no ray hits it from inside, so there is no box projection.");
  if (probe.influence && flat(*probe.influence)) say("influence", "is flat: the probe lights nothing.");
  if (probe.mode != ProbeMode::Custom && !probe.image.empty()) say("image", "is used only by mode custom.");
  if (probe.decode && probe.encoding == ImageEncoding::Linear) {
    say("decode", "is not used by encoding linear; name the picture's: rgbm, dldr or rgbmLinear.");
  }
  latticeRemarks(remarks, scene, probe);
  parameterRemarks(remarks, probe);
  budgetRemarks(remarks, probe);
}

void lightRemarks(Remarks& remarks, const Scene& scene, std::size_t index) {
  const Light& light = scene.lights[index];
  if (light.shadows == LightShadows::None) return;
  const KeyPath path{"lights", "[" + std::to_string(index) + "]", "shadows"};
  if (scene.probes.empty()) return remark(remarks, path, "need a probe, whose coverage throws them.");
  if (index >= kMostShadowLights) {
    return remark(remarks, path, "are thrown of the first " + std::to_string(kMostShadowLights) + " lights only.");
  }
  for (const Probe& probe : scene.probes) {
    if (lightOutside(light, probe)) continue;
    remark(remarks, path, "has no effect in probe \"" + probe.name + "\", in whose box the light itself lies.");
  }
}

}  // namespace

std::vector<std::string> featuresNotUsed(const Scene& scene) {
  Remarks remarks;
  for (const Probe& probe : scene.probes) probeRemarks(remarks, scene, probe);
  const bool anyMoves =
      std::any_of(scene.objects.begin(), scene.objects.end(), [](const auto& object) { return object.second.dynamic; });
  for (const Probe& probe : scene.probes) {
    if (scene.mirrors.empty() || !anyMoves || probe.mode != ProbeMode::Realtime) continue;
    remark(remarks, {"probes", probe.name, "mode"},
           "is realtime: it sees what moves, and a planar mirror in its reach shows that a second time.");
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) lightRemarks(remarks, scene, i);
  if (scene.lights.size() > kMostShadowLights + 1) {
    remark(remarks, {"lights"},
           "are " + std::to_string(scene.lights.size()) + ", and " + std::to_string(kMostShadowLights) +
               " can have shadows: directional ones first, then those that ask for them. The others shine through "
               "everything.");
  }
  return remarks;
}

std::vector<std::string> unmatchedOverrides(const Scene& scene, const std::vector<const Model*>& models) {
  std::vector<std::string> materials, nodes;
  for (const Model* model : models) {
    for (const Material& material : model->materials) materials.push_back(material.name);
    for (const Instance& instance : model->instances) nodes.push_back(instance.node);
  }
  for (auto* names : {&materials, &nodes}) {
    std::sort(names->begin(), names->end());
    names->erase(std::unique(names->begin(), names->end()), names->end());
  }
  Remarks remarks;
  const auto check = [&remarks](const KeyPath& path, const std::string& name, const std::vector<std::string>& known,
                                const std::string& kind) {
    if (std::binary_search(known.begin(), known.end(), name)) return;
    const std::string guess = didYouMean(name, known);
    remark(remarks, path,
           "no " + kind + " of the models is called \"" + name + "\"" +
               (guess.empty() ? "; they are " + nameList(known) + "." : guess));
  };
  for (const auto& [name, material] : scene.materials) check({"materials", name}, name, materials, "material");
  for (const auto& [name, object] : scene.objects) check({"objects", name}, name, nodes, "node");
  for (const auto& [name, mirror] : scene.mirrors) check({"mirrors", name}, name, nodes, "node");
  for (const Probe& probe : scene.probes) {
    for (std::size_t i = 0; i < probe.hides.size(); ++i) {
      check({"probes", probe.name, "hides", "[" + std::to_string(i) + "]"}, probe.hides[i], nodes, "node");
    }
  }
  return remarks;
}

}  // namespace boxprobe
