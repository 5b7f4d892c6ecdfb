// See explanation_json.h.
#include "app/session/explanation_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/session/valid_json.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/read_number.h"
#include "filters/explain/explanation_sections.h"

namespace boxprobe {

namespace {

using Json = nlohmann::ordered_json;

/// A float with the digits it has: 0.1f as 0.1, where a plain conversion would write those of its double.
Json number(float value) {
  if (!std::isfinite(value)) return nullptr;
  const std::string text = numberText(value);
  double shortest = 0.0;
  readNumber(text.data(), text.data() + text.size(), shortest);
  return shortest;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <typename Vector>
Json vector(const Vector& v) {
  return Json::array({number(v[0]), number(v[1]), number(v[2])});
}

template <typename Value>
Json orNull(const std::optional<Value>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_floating_point_v<Value>) {
    return number(*value);
  } else {
    return vector(*value);
  }
}

Json surfaceJson(const Explanation& e) {
  const SurfacePoint& s = e.surface;
  return {{"object", s.object},
          {"material", s.material},
          {"eyeWorld", vector(s.eyeWorld)},
          {"albedo", vector(s.albedo)},
          {"metallic", number(s.metallic)},
          {"roughness", number(s.roughness)},
          {"occlusion", number(s.occlusion)},
          {"opacity", number(s.opacity)},
          {"coatStrength", number(s.coatStrength)},
          {"nDotV", number(e.nDotV)},
          {"f0", vector(e.f0)},
          {"splitSum", Json::array({number(e.brdf.x), number(e.brdf.y)})}};
}

Json lookupJson(const Lookup& lookup) {
  Json texels = Json::array();
  for (const TexelShare& t : lookup.texels) {
    texels.push_back({{"level", t.level},
                      {"face", cubeFaceName(t.face)},
                      {"column", t.column},
                      {"row", t.row},
                      {"share", number(t.share)}});
  }
  return {{"direction", vector(lookup.direction)}, {"level", number(lookup.level)},
          {"roughness", number(lookup.roughness)}, {"weight", number(lookup.weight)},
          {"value", vector(lookup.value)},         {"texels", texels}};
}

Json diffuseJson(const DiffuseExplanation& d) {
  Json lamps = Json::array(), nodes = Json::array();
  for (const LampAtPoint& lamp : d.lamps) {
    lamps.push_back({{"object", lamp.node}, {"light", vector(lamp.light)}, {"filled", number(lamp.filled)}});
  }
  for (const LatticeNodeAtPoint& node : d.nodes) {
    nodes.push_back({{"node", {node.node.x, node.node.y, node.node.z}},
                     {"positionProbe", vector(node.positionProbe)},
                     {"weight", number(node.weight)},
                     {"ownLight", node.known}});
  }
  return {{"lamps", lamps},
          {"lattice",
           {{"nodes", {d.nodeCount.x, d.nodeCount.y, d.nodeCount.z}}, {"light", vector(d.lattice)}, {"at", nodes}}}};
}

Json probeJson(const ProbeExplanation& p) {
  Json json = {{"name", p.name},
               {"weight", number(p.weight)},
               {"technique", p.technique},
               {"slabFactors", orNull(p.slabFactors)},
               {"hitDistance", orNull(p.hitDistance)},
               {"hitWorld", p.hitDistance ? vector(p.hitWorld) : Json(nullptr)}};
  json["boxDistance"] = orNull(p.boxDistance);
  json["bevel"] = number(p.bevel);
  json["occlusion"] = orNull(p.occlusion);
  if (p.coverage) {
    json["coverage"] = number(*p.coverage);
    json["openSky"] = vector(p.openSky);
    json["openSkyLevel"] = number(p.openSkyLevel);
  }
  json["distanceLookups"] = p.distanceLookups;
  json["face"] = p.face >= 0 ? Json(boxFaceName(p.face)) : Json(nullptr);
  json["influence"] = number(p.influence);
  json["intensity"] = number(p.intensity);
  json["captured"] = p.captured;
  json["originWorld"] = vector(p.originWorld);
  json["positionProbe"] = vector(p.positionProbe);
  json["reflectionProbe"] = vector(p.reflectionProbe);
  json["boxProbe"] = {{"min", vector(p.boxMin)}, {"max", vector(p.boxMax)}};
  json["lookupDirection"] = vector(p.lookupDirection);
  json["maxLevel"] = number(p.maxLevel);
  json["trueDistance"] = orNull(p.trueDistance);
  json["specular"] = vector(p.specular);
  json["irradianceOverPi"] = vector(p.irradiance);
  if (!p.diffuse.nodes.empty()) json["diffuse"] = diffuseJson(p.diffuse);
  json["lookups"] = Json::array();
  for (const Lookup& lookup : p.lookups) json["lookups"].push_back(lookupJson(lookup));
  return json;
}

Json glassJson(const GlassExplanation& g) {
  return {{"form", g.form},
          {"back", g.back},
          {"ior", number(g.ior)},
          {"eta", number(g.eta)},
          {"reflectance", number(g.reflectance)},
          {"totallyReflected", g.reflectance >= 1.0f},
          {"direction", vector(g.directionWorld)},
          {"exitWorld", vector(g.exitWorld)},
          {"distance", number(g.distance)},
          {"roughness", number(g.roughness)},
          {"mirrored", g.mirrored},
          {"transmittance", vector(g.transmittance)},
          {"passed", vector(g.passed)},
          {"lookedUp", vector(g.looked)},
          {"light", vector(g.light())},
          {"drawnBehind", number(g.stands)}};
}

Json boxJson(const Box& box) {
  return {{"min", vector(box.min)}, {"max", vector(box.max)}};
}

/// `mend` holds the fields of the scene file that it changes, with their new values.
Json verdictJson(const Verdict& verdict) {
  Json json = {{"sentence", verdict.sentence.english()}, {"mend", nullptr}};
  if (!verdict.mend) return json;
  const Probe& after = verdict.mend->after;
  json["mend"] = {{"words", verdict.mend->words.english()},
                  {"probe", verdict.mend->probe},
                  {"box", boxJson(after.box)},
                  {"influence", after.influence ? boxJson(*after.influence) : Json(nullptr)},
                  {"projection", after.projection},
                  {"technique", after.technique}};
  return json;
}

}  // namespace

std::string explanationJson(const Explanation& e, const std::optional<Verdict>& verdict) {
  const Json none = nullptr;
  Json json;
  json["pixel"] = Json::array({e.x, e.y});
  json["background"] = !e.hit;
  if (verdict) json["verdict"] = verdictJson(*verdict);
  json["positionWorld"] = e.hit ? vector(e.surface.positionWorld) : none;
  json["normalWorld"] = e.hit ? vector(e.surface.normalWorld) : none;
  json["viewWorld"] = e.hit ? vector(e.surface.viewWorld) : none;
  json["reflectionWorld"] = e.hit ? vector(e.reflectionWorld) : none;
  json["color"] = vector(e.rendered.value_or(e.color));
  json["colorComputed"] = vector(e.color);
  const auto difference = relativeDifference(e);
  json["differenceOfBrightestTexel"] = difference ? number(*difference) : none;
  json["direct"] = vector(e.direct);
  json["emissive"] = vector(e.emissive);
  json["irradianceOverPi"] = e.irradiance ? vector(*e.irradiance) : Json(nullptr);
  json["diffuse"] = vector(e.diffuse);
  const float whole = e.color.x + e.color.y + e.color.z;
  json["diffuseShare"] = whole > 0.0f ? number((e.diffuse.x + e.diffuse.y + e.diffuse.z) / whole) : Json(nullptr);
  json["specular"] = vector(e.specular);
  json["coat"] = vector(e.coat);
  json["sheen"] = vector(e.sheen);
  json["glass"] = e.glass ? glassJson(*e.glass) : none;
  json["sky"] = {{"weight", number(e.skyWeight)}, {"level", number(e.skyLevel)}, {"value", vector(e.skyValue)}};
  json["mirror"] = e.mirror ? Json{{"light", vector(e.mirror->light)}, {"coverage", number(e.mirror->coverage)},
                                   {"share", number(e.mirror->share)}, {"hitDistance", number(e.mirror->hitDistance)},
                                   {"level", number(e.mirror->level)}, {"fetches", e.mirror->fetches}}
                            : none;
  json["surface"] = e.hit ? surfaceJson(e) : none;
  json["lookupCount"] = e.lookupCount;
  json["probes"] = Json::array();
  for (const ProbeExplanation& p : e.probes) json["probes"].push_back(probeJson(p));
  json["notes"] = english(e.notes);
  // Names in model files need not be UTF-8.
  return validJson(json);
}

}  // namespace boxprobe
