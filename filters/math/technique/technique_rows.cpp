// The rows of projections and evaluations, in the one translation unit that compiles the shader files as C++. Each host
// supplies PROBE_MAP and fetchProbe: a sampler and textureLod on the GPU, a CubeSampler here.
#include "filters/math/cube/light_table.h"
#include "filters/math/cube/relief.h"
#include "filters/math/sampling/blue_noise.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/math/shared/glsl_built_ins.h"
#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/automatic.h"
#include "filters/math/technique/technique_table.h"

#define PROBE_MAP ProbeMap
#define DISTANCE_MAP DistanceMap
#define BP_BEVEL

namespace boxprobe::shading {

using glm::uint;

#include "shaders/shared/finite.glsl"  // what both fetches use

static vec4 fetchProbe(ProbeMap map, const ProbeShape&, vec3 direction, float level) {
  return map->fetch(lookupDirection(direction), level);
}

static float fetchDistance(DistanceMap map, const ProbeShape&, vec3 direction) {
  return map->fetchDistance(direction);
}

#include "shaders/shared/relief.glsl"

vec3 fetchProbePlane(const ProbeShape& probe, vec3 direction) {
  if (probe.slot == nullptr || probe.slot->relief == nullptr) return vec3(0.0f);
  const glm::mat3* turn = probe.slot->mapFromProbe;
  const vec3 plane(probe.slot->relief->fetchRelief(turn != nullptr ? *turn * direction : direction, 0.0f));
  return turn != nullptr ? glm::transpose(*turn) * plane : plane;
}

vec3 fetchProbeFar(const ProbeShape& probe, vec3 direction) {
  if (probe.slot == nullptr || probe.slot->relief == nullptr) return vec3(0.0f);
  const glm::mat3* turn = probe.slot->mapFromProbe;
  const vec3 inMap = turn != nullptr ? *turn * direction : direction;
  const vec3 away = reliefFar(probe.slot->relief->fetchRelief(inMap, 0.0f).w, inMap);
  return turn != nullptr ? glm::transpose(*turn) * away : away;
}

static vec3 reliefFromProbe(const ProbeShape& probe, vec3 v) {
  const glm::mat3* turn = probe.slot != nullptr ? probe.slot->mapFromProbe : nullptr;
  return turn != nullptr ? *turn * v : v;
}

static float probeReliefSize(const ProbeShape& probe) {
  return probe.slot != nullptr && probe.slot->relief != nullptr ? probe.slot->relief->reliefSize() : 1.0f;
}

static vec4 fetchProbeRelief(const ProbeShape& probe, vec3 inMap, float level) {
  return probe.slot != nullptr && probe.slot->relief != nullptr ? probe.slot->relief->fetchRelief(inMap, level)
                                                                : vec4(0.0f);
}

static int probeBlockCount(const ProbeShape& probe) {
  return probe.slot != nullptr && probe.slot->blocks != nullptr ? probe.slot->blocks->count : 0;
}

static vec3 probeBlockLow(const ProbeShape& probe, int i) {
  return probe.slot->blocks->low[static_cast<std::size_t>(i)];
}

static vec3 probeBlockHigh(const ProbeShape& probe, int i) {
  return probe.slot->blocks->high[static_cast<std::size_t>(i)];
}

static int probeLightSize(const ProbeShape& probe) {
  return probe.slot != nullptr && probe.slot->light != nullptr ? probe.slot->light->faceSize : 0;
}

static vec4 fetchProbeLight(const ProbeShape& probe, int cell) {
  return probe.slot->light->cells[static_cast<std::size_t>(cell)];
}

static vec3 mapFromProbe(const ProbeShape& probe, vec3 direction) {
  const glm::mat3* turn = probe.slot->mapFromProbe;
  return turn != nullptr ? *turn * direction : direction;
}

static vec3 probeFromMap(const ProbeShape& probe, vec3 direction) {
  const glm::mat3* turn = probe.slot->mapFromProbe;
  return turn != nullptr ? glm::transpose(*turn) * direction : direction;
}

static vec2 splitSumAt(float cosine, float roughness) {
  return splitSum(cosine, roughness);
}

static vec2 fetchBlueNoise(ivec2 pixel) {
  return blueNoiseAt(pixel);
}

// A projection may ignore the normal or the box: all rows share one signature.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "shaders/shared/box_occlusion.glsl"
#include "shaders/shared/cube.glsl"
#include "shaders/shared/edge_fixup.glsl"  // after cube.glsl, which it uses
#include "shaders/shared/fresnel.glsl"
#include "shaders/shared/ggx.glsl"
#include "shaders/shared/hash.glsl"
#include "shaders/shared/level_curve.glsl"  // after roughness.glsl, which it uses
#include "shaders/shared/light_falloff.glsl"
#include "shaders/shared/lobe_frame.glsl"
#include "shaders/shared/roughness.glsl"
#include "shaders/shared/rounded_box.glsl"
#include "shaders/shared/sh.glsl"
#include "shaders/shared/sky.glsl"
#include "shaders/shared/slab.glsl"
#include "shaders/shared/source_level.glsl"
#include "shaders/shared/split_sum.glsl"  // after fresnel.glsl, which it uses
#include "shaders/shared/true_hit.glsl"   // after cube.glsl and slab.glsl, which it uses
#include "shaders/shared/weights.glsl"
// After slab.glsl, which they use.
#include "shaders/shared/footprint.glsl"       // after roughness.glsl and lobe_frame.glsl, which it uses
#include "shaders/shared/light_sampling.glsl"  // after cube.glsl and slab.glsl, which it uses
#include "shaders/shared/relief_march.glsl"
#include "shaders/shared/sample_pattern.glsl"  // after hash.glsl, which it uses
#include "shaders/shared/visible_normal.glsl"
#include "technique_files.inc"  // all of shaders/technique
#pragma GCC diagnostic pop

ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection) {
  return projectionRows()[static_cast<std::size_t>(probe.projection)].project(probe, position, normal, reflection);
}

// As the renderer would resolve it for a draw of this point's roughness.
static vec4 evaluateAutomatic(ProbeMap map, ProbeShape probe, ShadingPoint point) {
  const double roughness = point.roughness;
  const Technique chosen = chooseAutomatic(roughness, roughness, probe.parameters.budget).technique;
  return evaluationRows()[static_cast<std::size_t>(chosen.evaluation)].evaluate(map, probe, point);
}

}  // namespace boxprobe::shading

namespace boxprobe {

const std::vector<ProjectionRow>& projectionRows() {
  static const std::vector<ProjectionRow> rows = {
      {"normal", "Normal (painted on)", "Samples along the surface normal: the picture sticks to the object.",
       "technique/projection_normal.glsl", "projectNormal", shading::projectNormal},
      {"infinite", "Infinite (no correction)",
       "Samples along the bare reflection vector: correct only for distant surroundings.",
       "technique/projection_infinite.glsl", "projectInfinite", shading::projectInfinite},
      {"sphere", "Sphere proxy", "Intersects the ray with the sphere around the box: straight walls bend.",
       "technique/projection_sphere.glsl", "projectSphere", shading::projectSphere},
      {"box", "Box projection",
       "Box projection (parallax correction): intersects the ray with the probe's box; exact where the room is the "
       "box.",
       "technique/projection_box.glsl", "projectBox", shading::projectBox},
      {"impostor",
       "Impostor (box refined)",
       "Refines the box's hit by the captured distances, or follows the ray through them: for rooms that are not "
       "boxes.",
       "technique/projection_impostor.glsl",
       "projectImpostor",
       shading::projectImpostor,
       {"technique/projection_box.glsl", "shared/relief_march.glsl"},
       {"steps"},
       true},
  };
  return rows;
}

const std::vector<EvaluationRow>& evaluationRows() {
  const std::vector<std::string_view> kFootprintFiles = {"shared/lobe_frame.glsl", "shared/footprint.glsl"};
  static const std::vector<EvaluationRow> rows = {
      {"none",
       "No contact hardening",
       "One lookup at the surface's own roughness, whatever the distance.",
       "technique/evaluation_none.glsl",
       "evaluateNone",
       shading::evaluateNone,
       {},
       {"curve"},
       false,
       {},
       LevelReach::Own},
      {"approximate",
       "Approximate hardening",
       "Sharper where the reflected surface is nearer than the hardening length.",
       "technique/evaluation_approximate.glsl",
       "evaluateApproximate",
       shading::evaluateApproximate,
       {},
       {"hardeningLength", "curve"},
       false,
       {},
       LevelReach::UpToOwn},
      {"hdrp",
       "HDRP / Frostbite hardening",
       "Sharper by the angle under which the capture origin sees the lobe's patch of wall.",
       "technique/evaluation_hdrp.glsl",
       "evaluateHdrp",
       shading::evaluateHdrp,
       {},
       {"curve"},
       false,
       {},
       LevelReach::UpToOwn},
      {"godot",
       "Godot hardening",
       "Sharper by distance and, by a Fresnel-like factor, at grazing angles.",
       "technique/evaluation_godot.glsl",
       "evaluateGodot",
       shading::evaluateGodot,
       {},
       {"hardeningLength", "fresnel", "power", "curve"},
       false,
       {},
       LevelReach::UpToOwn},
      {"footprint1",
       "One footprint",
       "One lookup at the mip level that matches the patch of wall under the lobe.",
       "technique/evaluation_footprint1.glsl",
       "evaluateFootprint1",
       shading::evaluateFootprint1,
       kFootprintFiles,
       {},
       true},
      {"footprint2",
       "Two footprints",
       "Divides the lobe into 2 pieces, each sampled at the mip level of its patch: reflections stretch at grazing "
       "angles.",
       "technique/evaluation_footprint2.glsl",
       "evaluateFootprint2",
       shading::evaluateFootprint2,
       kFootprintFiles,
       {},
       true},
      {"footprint4",
       "Four footprints",
       "Divides the lobe into 4 pieces, each sampled at the mip level of its patch: reflections stretch at grazing "
       "angles.",
       "technique/evaluation_footprint4.glsl",
       "evaluateFootprint4",
       shading::evaluateFootprint4,
       kFootprintFiles,
       {},
       true,
       "footprint1"},
      {"footprint8",
       "Eight footprints",
       "Divides the lobe into 8 pieces, each sampled at the mip level of its patch: reflections stretch at grazing "
       "angles.",
       "technique/evaluation_footprint8.glsl",
       "evaluateFootprint8",
       shading::evaluateFootprint8,
       kFootprintFiles,
       {},
       true,
       "footprint1"},
      {"footprint16",
       "Sixteen footprints",
       "Divides the lobe into 16 pieces, each sampled at the mip level of its patch: reflections stretch at grazing "
       "angles.",
       "technique/evaluation_footprint16.glsl",
       "evaluateFootprint16",
       shading::evaluateFootprint16,
       kFootprintFiles,
       {},
       true,
       "footprint1"},
      {"raytraced",
       "Ray-traced",
       "Follows random rays of the surface's lobe to the proxy: the others approximate this; noisy with few rays.",
       "technique/evaluation_raytraced.glsl",
       "evaluateRaytraced",
       shading::evaluateRaytraced,
       {"shared/lobe_frame.glsl", "shared/footprint.glsl", "shared/hash.glsl", "shared/sample_pattern.glsl",
        "shared/visible_normal.glsl", "shared/cube.glsl", "shared/light_sampling.glsl",
        "technique/evaluation_footprint1.glsl"},
       {"samples", "total", "pattern", "animated", "levelOffset", "filtered", "sampling", "blur"},
       false,
       "footprint1"},
      {"auto",
       "Automatic",
       "Chooses for each object the cheapest evaluation whose measured error stays within the budget at its roughness.",
       "filters/math/technique/automatic.cpp",
       "",
       shading::evaluateAutomatic,
       {},
       {"budget"},
       true},
  };
  return rows;
}

}  // namespace boxprobe
