// shaders/shared and shaders/technique compiled as C++ through GLM: one source for pictures and their explanations. The
// definitions are in shared_math.cpp, the only translation unit that includes the shader files; the structs come from
// shaders/shared/types.glsl itself.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace boxprobe {
struct LightTable;
struct ReliefBlocks;
}  // namespace boxprobe

namespace boxprobe::shading {

/// A prefiltered cubemap; implements `fetchProbe` in C++.
class CubeSampler {
 public:
  virtual ~CubeSampler() = default;
  /// Trilinear, seamless across faces. `direction` need not be unit; `level` is clamped to the chain.
  virtual glm::vec4 fetch(const glm::vec3& direction, float level) const = 0;
};
using ProbeMap = const CubeSampler*;

/// A probe's distances; implements `fetchDistance` in C++.
class DistanceSampler {
 public:
  virtual ~DistanceSampler() = default;
  /// Distance in scene units of the nearest texel; 0 where the probe saw nothing. `direction` need not be unit.
  virtual float fetchDistance(const glm::vec3& direction) const = 0;
};
using DistanceMap = const DistanceSampler*;

/// A probe's relief (relief.h).
class ReliefSampler {
 public:
  virtual ~ReliefSampler() = default;
  /// The value of the nearest texel: see Relief::fetchRelief. `direction` need not be unit. `level`: an integer, at
  /// most log2(reliefSize()).
  virtual glm::vec4 fetchRelief(const glm::vec3& direction, float level) const = 0;
  /// Texels along a face of level 0.
  virtual float reliefSize() const = 0;
};

/// What a technique may fetch from a probe besides its map; a null member gives nothing. Must outlive the call.
struct ProbeData {
  const ReliefSampler* relief = nullptr;    ///< looked up in the map's axes relative to the capture origin
  const ReliefBlocks* blocks = nullptr;     ///< probe frame
  const glm::mat3* mapFromProbe = nullptr;  ///< null: the map lies along the box's axes
  const LightTable* light = nullptr;        ///< to aim rays by brightness
};

using glm::ivec2;
using glm::uint;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#define PROBE_SLOT const ProbeData*
#include "shaders/shared/types.glsl"
#undef PROBE_SLOT

/// The plane of what the probe saw, in its frame: see Relief. 0 where it saw nothing or has no distances.
vec3 fetchProbePlane(const ProbeShape& probe, vec3 direction);
/// The direction to sample for what is far away; 0 where nothing far was seen.
vec3 fetchProbeFar(const ProbeShape& probe, vec3 direction);
vec3 reliefDirection(float code);
vec3 reliefFar(float code, vec3 direction);
vec3 finiteOr(vec3 v, vec3 instead);
vec3 directionOr(vec3 v, vec3 instead);
float roughnessWithin(float roughness);
vec3 reflectedView(vec3 normal, vec3 view);
vec3 lookupDirection(vec3 direction);
float slabFactor(float position, float direction, float boxMin, float boxMax);
vec3 slabFactors(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax);
float boxOcclusion(float hitDistance, float multiplier, float power, float strength);
float roundedBoxExit(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax, float bevel, float exit);
float roughnessForLevel(float level, float maxLevel);
float levelForRoughness(float roughness, float maxLevel);
float levelForCurve(ProbeShape probe, float roughness);
float faceWeight(float distanceInside, float rate);
float influenceWeight(vec3 position, vec3 influenceMin, vec3 influenceMax, vec3 rateMin, vec3 rateMax);
float groupScale(float weightSum);
float remainingAfter(float remaining, float weightSum);
float groupShare(float remaining, float weightSum);
float onlyProbesScale(float remaining);
float onlyProbesRemaining(float remaining);
vec3 schlickFresnel(vec3 f0, vec3 f90, float cosine);
float meanFresnel(vec3 f0, vec3 f90, float cosine);
float relativeF0(vec3 f0, vec3 f90);
vec2 splitSumPlace(float cosine, float roughness, float size);
vec3 multipleScattering(vec3 f0, vec2 splitSum);
float coatPasses(float strength, float coatF0, float cosine);
vec3 cubeDirection(int face, float s, float t);
vec3 cubeTexelCentre(vec3 direction, float faceSize);
int cubeCell(vec3 direction, int faceSize);
float trueHitDistance(DistanceMap map, ProbeShape probe, float faceSize, vec3 position, vec3 reflection, float reach);
float footprintScale(ProbeShape probe, ProbeHit hit, vec3 direction);
float footprintLevel(ProbeShape probe, float alphaSquared, float bias);
FootprintLobe footprintLobe(ShadingPoint point, float points);
FootprintSum footprintStart();
FootprintSum footprintAdd(ProbeMap map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum,
                          float u, float v, float weight, float size);
FootprintSum footprintAddPair(ProbeMap map, ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintSum sum,
                              float u, float v, float weight, float size);
FootprintPatch footprintPatch(ProbeShape probe, ShadingPoint point, FootprintLobe lobe, float u, float v, float weight);
FootprintPatch footprintExtend(ProbeShape probe, ShadingPoint point, FootprintLobe lobe, FootprintPatch seen, float u,
                               float v, float weight);
vec4 footprintMean(ProbeMap map, ProbeShape probe, FootprintPatch seen, float narrow, float wide, float bias);
uint hashed(uint value);
uint pixelHash(ivec2 pixel);
SamplePattern samplePattern(ShadingPoint point, int pattern, int samples);
vec2 samplePoint(SamplePattern pattern, int i);
LobeSample lobeSample(FootprintLobe lobe, vec2 u);
LobeSample lobeTowards(FootprintLobe lobe, vec3 direction);
vec3 ggxHalfVector(vec2 u, float alpha);
float ggxDistribution(vec3 h, float alpha);
float ggxMasking(float c, float alpha);
vec3 lobeTangent(vec3 n);
vec3 lobeBitangent(vec3 n);
float edgeFixupShare(float texelsFromEdge, float width);
float edgeFixupPull(float share, float other);
vec3 directionAcrossEdge(int face, float side, float along, bool alongT, float faceSize);
float sourceLookup(float centre, float side, float faceSize);
float sourceWeight(float s, float t);
vec3 shIrradiance(vec3 n, vec3 c0, vec3 c1, vec3 c2, vec3 c3, vec3 c4, vec3 c5, vec3 c6, vec3 c7, vec3 c8);
float distanceFalloff(float distance, float perRange);
float coneFalloff(float cosine, float cosineOuter, float cosineInner);
vec3 skyGradient(vec3 direction, vec3 top, vec3 horizon, vec3 ground);

/// Dispatches on probe.projection through the technique table.
ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection);

}  // namespace boxprobe::shading
