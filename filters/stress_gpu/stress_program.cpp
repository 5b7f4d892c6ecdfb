// See stress_program.h.
#include "filters/stress_gpu/stress_program.h"

#include <algorithm>
#include <cmath>

#include "filters/math/technique/technique_table.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

using namespace stress;

namespace {

std::vector<std::string> baseFiles() {
  return {"shared/types.glsl",     "shared/finite.glsl", "shared/slab.glsl",
          "shared/roughness.glsl", "shared/relief.glsl", "stress/echo.glsl"};
}

template <typename Files>
void append(std::vector<std::string>& files, const Files& more) {
  for (const auto& file : more) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.emplace_back(file);
  }
}

std::string projectRayText(const ProjectionRow& row) {
  return "ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n{\n  return " +
         std::string(row.function) + "(probe, position, normal, reflection);\n}\n";
}

StressProgram techniqueProgram(const Technique& technique) {
  const ProjectionRow& projection = projectionRows()[static_cast<std::size_t>(technique.projection)];
  const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(technique.evaluation)];
  std::vector<std::string> files = baseFiles();
  append(files, projection.sharedFiles);
  files.emplace_back(projection.shaderFile);
  std::vector<std::string> after;
  append(after, std::vector<std::string>{"shared/level_curve.glsl"});
  append(after, evaluation.sharedFiles);
  after.emplace_back(evaluation.shaderFile);

  StressProgram program;
  program.technique = true;
  program.declarations = joinShaderSources(files) + projectRayText(projection) + joinShaderSources(after);
  program.body =
      "  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);\n"
      "  out0 = " +
      std::string(evaluation.function) +
      "(0, probe, point);\n"
      "  out1 = vec4(hit.direction, hit.distance);\n";
  program.onCpu = [technique, &evaluation](const StressInput& input) {
    LocalInput in = localInput(input);
    const StressMap map(in.probe);
    const shading::ProbeData data = map.probeData();
    in.probe.projection = technique.projection;
    in.probe.bevel = 0.0f;
    in.probe.slot = &data;
    const shading::ProbeHit hit =
        shading::projectRay(in.probe, in.point.position, in.point.normal, in.point.reflection);
    return StressValues{evaluation.evaluate(&map, in.probe, in.point), {hit.direction, hit.distance}};
  };
  return program;
}

struct Term {
  const char* subject;
  std::vector<std::string> files;
  const char* body;
  glm::vec4 (*onCpu)(const LocalInput& in, const StressInput& input);
};

// `extra`: two numbers from which a half vector is drawn, the blend rate, and which half of the half vectors.
const std::vector<Term>& terms() {
  using shading::ShadingPoint;
  static const std::vector<Term> rows = {
      {"term:footprint-scale",
       {"technique/projection_box.glsl"},
       "  ProbeHit hit = projectBox(probe, point.position, point.normal, point.reflection);\n"
       "  out0.x = footprintScale(probe, hit, point.reflection);\n",
       [](const LocalInput& in, const StressInput&) {
         return glm::vec4(shading::footprintScale(in.probe, boxHit(in), in.point.reflection), 0.0f, 0.0f, 0.0f);
       }},
      {"term:rounded-box",
       {"shared/rounded_box.glsl"},
       "  vec3 f = slabFactors(point.position, point.reflection, probe.boxMin, probe.boxMax);\n"
       "  float exit = min(min(f.x, f.y), f.z);\n"
       "  out0.x = roundedBoxExit(point.position, point.reflection, probe.boxMin, probe.boxMax, in3.w, exit);\n",
       [](const LocalInput& in, const StressInput&) {
         return glm::vec4(shading::roundedBoxExit(in.point.position, in.point.reflection, in.probe.boxMin,
                                                  in.probe.boxMax, in.probe.bevel, boxHit(in).distance),
                          0.0f, 0.0f, 0.0f);
       }},
      {"term:ggx-distribution",
       {"shared/ggx.glsl"},
       "  float alpha = point.roughness * point.roughness;\n"
       "  vec3 h = extra.w > 0.5 ? ggxHalfVector(extra.xy, alpha) : point.normal;\n"
       "  out0.x = log2(1.0 + ggxDistribution(h, alpha));\n",
       [](const LocalInput& in, const StressInput& input) {
         const float alpha = in.point.roughness * in.point.roughness;
         const glm::vec3 h =
             (input.pixel.x & 1) != 0 ? shading::ggxHalfVector(lobeNumbers(input), alpha) : in.point.normal;
         return glm::vec4(std::log2(1.0f + shading::ggxDistribution(h, alpha)), 0.0f, 0.0f, 0.0f);
       }},
      {"term:ggx-masking",
       {"shared/ggx.glsl"},
       "  out0.x = ggxMasking(clamp(dot(point.normal, point.view), 0.0, 1.0), point.roughness * point.roughness);\n",
       [](const LocalInput& in, const StressInput&) {
         const float cosine = std::clamp(glm::dot(in.point.normal, in.point.view), 0.0f, 1.0f);
         return glm::vec4(shading::ggxMasking(cosine, in.point.roughness * in.point.roughness), 0.0f, 0.0f, 0.0f);
       }},
      {"term:blend-weight",
       {"shared/weights.glsl"},
       "  float w = influenceWeight(point.position, probe.boxMin, probe.boxMax, vec3(extra.z), vec3(extra.z));\n"
       "  out0.xyz = vec3(w, groupScale(w + 0.5), remainingAfter(1.0, w + 0.5));\n",
       [](const LocalInput& in, const StressInput& input) {
         const float w = shading::influenceWeight(in.point.position, in.probe.boxMin, in.probe.boxMax,
                                                  glm::vec3(blendRate(input)), glm::vec3(blendRate(input)));
         return glm::vec4(w, shading::groupScale(w + 0.5f), shading::remainingAfter(1.0f, w + 0.5f), 0.0f);
       }},
      {"term:reflection",
       {},
       "  out0.xyz = reflectedView(point.normal, point.view);\n",
       [](const LocalInput& in, const StressInput&) {
         return glm::vec4(shading::reflectedView(in.point.normal, in.point.view), 0.0f);
       }},
      {"term:level",
       {},
       "  float p = roughnessForLevel(point.roughness * probe.maxLevel, probe.maxLevel);\n"
       "  out0.xw = vec2(p, levelForRoughness(p, probe.maxLevel));\n",
       [](const LocalInput& in, const StressInput&) {
         const float p = shading::roughnessForLevel(in.point.roughness * in.probe.maxLevel, in.probe.maxLevel);
         return glm::vec4(p, 0.0f, 0.0f, shading::levelForRoughness(p, in.probe.maxLevel));
       }},
      {"term:lobe-frame",
       {"shared/lobe_frame.glsl"},
       "  out0.xyz = lobeTangent(point.normal);\n  out1.xyz = lobeBitangent(point.normal);\n",
       [](const LocalInput& in, const StressInput&) { return glm::vec4(shading::lobeTangent(in.point.normal), 0.0f); }},
      {"term:true-hit",
       {"shared/cube.glsl", "shared/true_hit.glsl"},
       "  vec3 sides = probe.boxMax - probe.boxMin;\n"
       "  float reach = 2.0 * max(max(sides.x, sides.y), max(sides.z, 1.0e-30));\n"
       "  out0.x = trueHitDistance(0, probe, 256.0, point.position, point.reflection, reach);\n",
       [](const LocalInput& in, const StressInput&) {
         const glm::vec3 sides = in.probe.boxMax - in.probe.boxMin;
         const float reach = 2.0f * std::max({sides.x, sides.y, sides.z, 1.0e-30f});
         const StressMap map(in.probe);
         return glm::vec4(
             shading::trueHitDistance(&map, in.probe, 256.0f, in.point.position, in.point.reflection, reach), 0.0f,
             0.0f, 0.0f);
       }},
  };
  return rows;
}

}  // namespace

std::optional<StressProgram> stressProgram(const StressSubject& subject) {
  if (subject.technique) {
    // `auto` is resolved in C++, per object; the techniques it chooses have rows of their own.
    const auto& row = evaluationRows()[static_cast<std::size_t>(subject.technique->evaluation)];
    return row.function.empty() ? std::nullopt : std::optional<StressProgram>(techniqueProgram(*subject.technique));
  }
  for (const Term& term : terms()) {
    if (subject.id != term.subject) continue;
    std::vector<std::string> files = baseFiles();
    append(files, term.files);
    StressProgram program;
    program.declarations = joinShaderSources(files);
    if (subject.id == "term:footprint-scale") {
      const auto box = static_cast<std::size_t>(parseTechnique("box")->projection);
      program.declarations += projectRayText(projectionRows()[box]) +
                              joinShaderSources({"shared/lobe_frame.glsl", "shared/footprint.glsl"});
    }
    program.body = term.body;
    if (term.onCpu != nullptr) {
      program.onCpu = [onCpu = term.onCpu](const StressInput& input) {
        return StressValues{onCpu(localInput(input), input), glm::vec4(0.0f)};
      };
    }
    return program;
  }
  return std::nullopt;
}

}  // namespace boxprobe
