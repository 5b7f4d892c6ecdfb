#include "filters/io/engines/technique_text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/engines/export_names.h"
#include "filters/io/engines/light_text.h"
#include "filters/io/engines/shader_literals.h"
#include "filters/math/cube/cube_filter.h"
#include "filters/math/shared/shader_source.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

using Words = std::map<std::string, std::string>;

bool wordLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Replaces whole words; "word(" matches only calls of it.
std::string withWords(const std::string& text, const Words& words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (!wordLetter(text[at])) {
      result += text[at++];
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && wordLetter(text[end])) ++end;
    const std::string word = text.substr(at, end - at);
    const auto called = end < text.size() && text[end] == '(' ? words.find(word + "(") : words.end();
    const auto plain = words.find(word);
    const bool member = at > 0 && text[at - 1] == '.';
    result += member ? word : called != words.end() ? called->second : plain != words.end() ? plain->second : word;
    at = end;
  }
  return result;
}

/// A preprocessor for shaders/shared and shaders/technique, which use #ifdef, #ifndef, #define and #endif: target
/// languages have none, or a different one.
std::string withoutDirectives(const std::string& text, Words defined) {
  std::istringstream lines(text);
  std::string kept;
  std::vector<bool> open;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string directive, name, value;
    words >> directive >> name >> value;
    const bool active = std::find(open.begin(), open.end(), false) == open.end();
    if (directive == "#ifdef" || directive == "#ifndef") {
      open.push_back((defined.count(name) != 0) == (directive == "#ifdef"));
    } else if (directive == "#endif") {
      open.pop_back();
    } else if (directive == "#define") {
      if (active) defined[name] = value;
    } else if (active) {
      kept += line + "\n";
    }
  }
  return withWords(kept, defined);
}

/// What a technique needs besides a cubemap; null: nothing.
const char* neededBesides(const ProjectionRow& projection, const EvaluationRow& evaluation) {
  if (projection.distances) return "the probe's distances";
  if (evaluation.function.empty()) return "this program to choose for each object";
  if (evaluation.id == "raytraced") return "blue noise and the probe's table of lights";
  return nullptr;
}

struct Chosen {
  Technique technique;
  const ProjectionRow& projection;
  const EvaluationRow& evaluation;
};

Chosen chosenTechnique(const std::string& id) {
  const auto technique = parseTechnique(id);
  if (!technique) throw InputError("--technique " + id + ": no such technique; there are: " + techniqueIdList());
  const ProjectionRow& projection = projectionRows()[static_cast<std::size_t>(technique->projection)];
  const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(technique->evaluation)];
  const char* missing = neededBesides(projection, evaluation);
  if (missing != nullptr) {
    throw InputError("--technique " + id + ": needs " + missing +
                     ", which a function alone does not have; box+footprint4 comes near it");
  }
  return {*technique, projection, evaluation};
}

/// Named pieces of text, each after the ones it depends on.
using Pieces = std::vector<std::pair<std::string, std::string>>;

Pieces sources(const Chosen& chosen, bool bevelled, bool occluded) {
  Pieces pieces;
  std::set<std::string_view> present;
  const auto add = [&](std::string_view file) {
    if (present.insert(file).second) pieces.emplace_back(file, std::string(shaderSource(file)) + "\n");
  };
  for (const char* file : {"shared/types.glsl", "shared/finite.glsl", "shared/slab.glsl", "shared/roughness.glsl"}) {
    add(file);
  }
  if (bevelled) add("shared/rounded_box.glsl");
  if (occluded) add("shared/box_occlusion.glsl");
  for (const std::string_view file : chosen.projection.sharedFiles) add(file);
  add(chosen.projection.shaderFile);
  const std::string function(chosen.projection.function);
  pieces.emplace_back(
      "call " + function,
      "ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n{\n  return " + function +
          "(probe, position, normal, reflection);\n}\n\n"
          "vec4 fetchProbe(PROBE_MAP map, ProbeShape probe, vec3 direction, float level)\n{\n"
          "  return textureLod(map, lookupDirection(direction), level);\n}\n\n");
  add("shared/level_curve.glsl");
  for (const std::string_view file : chosen.evaluation.sharedFiles) add(file);
  add(chosen.evaluation.shaderFile);
  return pieces;
}

std::string entry(const Chosen& chosen, bool bevelled, bool occluded) {
  return std::string(
             "// A probe of the scene: where it is, in world space and scene units.\n"
             "struct BoxprobeProbe\n{\n"
             "  vec3 origin;  // where the cubemap was captured\n"
             "  vec3 axisX;   // of the box and of the cubemap, unit, in the world\n"
             "  vec3 axisY;\n  vec3 axisZ;\n"
             "  vec3 bevelAndIntensity;  // radius of the box's edges: x + y * roughness; z: intensity\n"
             "  vec3 occlusion;          // multiplier, power, strength\n"
             "  ProbeShape shape;\n};\n\n"
             "vec3 boxprobeTurned(BoxprobeProbe boxprobe, vec3 v)\n{\n"
             "  return vec3(dot(v, boxprobe.axisX), dot(v, boxprobe.axisY), dot(v, boxprobe.axisZ));\n}\n\n"
             "// What a probe reflects at a surface: radiance times coverage, and coverage. World space; normal and "
             "view "
             "(towards the\n// eye) unit, roughness perceptual. The cubemap's levels and axes are those of `--ladder "
             "own`.\n"
             "// `f0`: the surface's reflectance straight on over that at the edge, which weighs the rays of a lobe.\n"
             "vec4 boxprobeReflectionOf(PROBE_MAP map, BoxprobeProbe boxprobe, vec3 position, vec3 normal, vec3 view, "
             "float roughness,\n                          float f0)\n{\n"
             "  ProbeShape shape = boxprobe.shape;\n"
             "  ShadingPoint point;\n"
             "  point.position = boxprobeTurned(boxprobe, position - boxprobe.origin);\n"
             "  point.normal = boxprobeTurned(boxprobe, normal);\n"
             "  point.view = boxprobeTurned(boxprobe, view);\n"
             "  point.reflection = reflectedView(point.normal, point.view);\n"
             "  point.roughness = roughnessWithin(roughness);\n"
             "  point.pixel = ivec2(0, 0);\n  point.frame = 0;\n  point.fresnel = 0.0f;\n  point.f0 = clamp(f0, "
             "1.0e-2f, 1.0e2f);\n") +
         (bevelled ? "  shape.bevel = boxprobe.bevelAndIntensity.x + boxprobe.bevelAndIntensity.y * point.roughness;\n"
                   : "") +
         "  vec4 value = " + std::string(chosen.evaluation.function) + "(map, shape, point);\n" +
         (occluded ? "  float reach = projectRay(shape, point.position, point.normal, point.reflection).distance;\n"
                     "  value = value * vec4(vec3(boxOcclusion(reach, boxprobe.occlusion.x, boxprobe.occlusion.y, "
                     "boxprobe.occlusion.z)), 1.0f);\n"
                   : "") +
         "  return value * vec4(vec3(boxprobe.bevelAndIntensity.z), 1.0f);\n}\n\n"
         "// The same at a metal, or where no reflectance is known.\n"
         "vec4 boxprobeReflection(PROBE_MAP map, BoxprobeProbe boxprobe, vec3 position, vec3 normal, vec3 view, "
         "float roughness)\n{\n"
         "  return boxprobeReflectionOf(map, boxprobe, position, normal, view, roughness, 1.0f);\n}\n\n";
}

std::string shapeFunction(const Probe& probe, const std::string& stem, const Chosen& chosen) {
  const ProbeGeometry g = probeGeometry(probe, probe.origin, probe.rotationDegrees);
  if (chosen.evaluation.id == "godot" && g.parameters.fresnel != 0) {
    throw InputError("probes." + probe.name +
                     ".parameters.fresnel: an exported function does not know the surface's "
                     "own Fresnel reflectance; choose the other one");
  }
  std::string name = stem;
  std::replace(name.begin(), name.end(), '-', '_');
  const auto set = [](const std::string& field, const std::string& value) {
    return "  boxprobe." + field + " = " + value + ";\n";
  };
  std::string text = "// " + probe.name + "\nBoxprobeProbe boxprobe_" + name + "()\n{\n  BoxprobeProbe boxprobe;\n";
  text.erase(std::remove_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(3 + probe.name.size()),
                            [](unsigned char c) { return c < 0x20; }),
             text.begin() + static_cast<std::ptrdiff_t>(3 + probe.name.size()));
  text += set("origin", shaderVector(g.originWorld)) + set("axisX", shaderVector(g.worldFromProbe[0])) +
          set("axisY", shaderVector(g.worldFromProbe[1])) + set("axisZ", shaderVector(g.worldFromProbe[2])) +
          set("bevelAndIntensity", shaderVector({g.bevelRadius, g.bevelFromRoughness, g.intensity})) +
          set("occlusion", shaderVector(g.occlusion)) + set("shape.boxMin", shaderVector(g.boxMin)) +
          set("shape.boxMax", shaderVector(g.boxMax)) +
          set("shape.maxLevel", shaderNumber(prefilterLevels(probe.faceSize) - 1)) +
          set("shape.projection", std::to_string(chosen.technique.projection)) + set("shape.bevel", "0.0f") +
          set("shape.slot", "0");
  for (const ParameterRow& row : parameterRows()) {
    const std::string field = "shape.parameters." + std::string(row.name);
    if (row.choice != nullptr) text += set(field, std::to_string(g.parameters.*row.choice));
    if (row.number != nullptr) text += set(field, shaderNumber(g.parameters.*row.number));
  }
  return text + "  return boxprobe;\n}\n\n";
}

/// Single-argument constructors, which HLSL lacks, and multi-argument ones of the same name.
const char* const kHlslConstructors =
    "SamplerState boxprobeSampler;  // trilinear, bound by the host\n\n"
    "float2 boxprobe2(float a) { return float2(a, a); }\n"
    "float2 boxprobe2(float a, float b) { return float2(a, b); }\n"
    "float3 boxprobe3(float a) { return float3(a, a, a); }\n"
    "float3 boxprobe3(float a, float b, float c) { return float3(a, b, c); }\n"
    "float4 boxprobe4(float a) { return float4(a, a, a, a); }\n"
    "float4 boxprobe4(float3 a, float b) { return float4(a, b); }\n\n";

std::string inHlsl(const std::string& text) {
  std::string result = withWords(text, {{"vec2", "float2"},
                                        {"vec3", "float3"},
                                        {"vec4", "float4"},
                                        {"ivec2", "int2"},
                                        {"vec2(", "boxprobe2"},
                                        {"vec3(", "boxprobe3"},
                                        {"vec4(", "boxprobe4"},
                                        {"mix", "lerp"},
                                        {"samplerCube", "TextureCube"},
                                        {"sampler3D", "Texture3D"},
                                        {"point", "surfacePoint"},   // reserved word
                                        {"linear", "linearTerm"}});  // reserved word
  for (const std::string texture : {"map", "nodes"}) {
    const std::string fetch = "textureLod(" + texture + ", ", sampled = texture + ".SampleLevel(boxprobeSampler, ";
    for (std::size_t at = 0; (at = result.find(fetch, at)) != std::string::npos;)
      result.replace(at, fetch.size(), sampled);
  }
  for (std::size_t at = 0; (at = result.find("\nconst ", at)) != std::string::npos; at += 7) {
    result.replace(at, 7, "\nstatic const ");
  }
  return kHlslConstructors + result;
}

}  // namespace

std::string techniqueText(const std::vector<Probe>& probes, const std::string& technique, ShaderLanguage language,
                          const std::string& writer, const std::vector<SceneLamp>& lamps) {
  const Chosen chosen = chosenTechnique(technique);
  const bool bevelled = std::any_of(probes.begin(), probes.end(), [](const Probe& p) { return p.bevel.has_value(); });
  const bool occluded =
      std::any_of(probes.begin(), probes.end(), [](const Probe& p) { return p.occlusion.has_value(); });
  Words defined = {{"PROBE_MAP", "samplerCube"}, {"LAMP_SLOT", "BoxprobeLamp"}};
  if (bevelled) defined["BP_BEVEL"] = "";
  std::string text;
  for (const auto& [name, piece] : sources(chosen, bevelled, occluded)) text += piece;
  text += entry(chosen, bevelled, occluded);
  std::vector<std::string> names;
  for (const Probe& probe : probes) names.push_back(probe.name);
  const std::vector<std::string> stems = exportStems(names);
  for (std::size_t i = 0; i < probes.size(); ++i) text += shapeFunction(probes[i], stems[i], chosen);
  text += lightText(lamps);
  text = withoutDirectives(text, defined);
  if (language == ShaderLanguage::Hlsl) text = inHlsl(text);
  return "// Technique " + techniqueId(chosen.technique) + " of " + writer + ", BSD-3-Clause.\n\n" + text;
}

TechniquePieces techniquePieces(bool bevelled, bool occluded) {
  TechniquePieces result;
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      if (neededBesides(projection, evaluation) != nullptr) continue;
      const Chosen chosen = chosenTechnique(std::string(projection.id) + "+" + std::string(evaluation.id));
      TechniquePieces::Row row{std::string(projection.id),
                               std::string(projection.label),
                               std::string(evaluation.id),
                               std::string(evaluation.label),
                               {}};
      Pieces pieces = sources(chosen, bevelled, occluded);
      pieces.emplace_back("call " + std::string(evaluation.function), entry(chosen, bevelled, occluded));
      for (auto& [name, text] : pieces) {
        row.pieces.push_back(name);
        result.texts.emplace(name, std::move(text));
      }
      result.rows.push_back(std::move(row));
    }
  }
  return result;
}

}  // namespace boxprobe
