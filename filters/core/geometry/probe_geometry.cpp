#include "filters/core/geometry/probe_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/box_tree.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/math/technique/automatic.h"

namespace boxprobe {

namespace {

// Counts a floor in a face of its room's box as inside: without this skin, rounding (1e-7 of the distance to the
// camera) would decide for each pixel when the blend distance is 0. Relative to the box, so it works at every scale.
constexpr double kInfluenceSkin = 1.0e-4;
constexpr double kNarrowestBlend = 1.0e-5;

double largestSide(const Box& box) {
  const glm::dvec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

double skinOf(const Box& box) {
  return kInfluenceSkin * largestSide(box);
}

}  // namespace

glm::dmat3 rotationMatrix(const glm::dvec3& rotationDegrees) {
  const glm::dvec3 a = rotationDegrees * (3.14159265358979323846 / 180.0);
  const glm::dmat3 x(1, 0, 0, 0, std::cos(a.x), std::sin(a.x), 0, -std::sin(a.x), std::cos(a.x));
  const glm::dmat3 y(std::cos(a.y), 0, -std::sin(a.y), 0, 1, 0, std::sin(a.y), 0, std::cos(a.y));
  const glm::dmat3 z(std::cos(a.z), std::sin(a.z), 0, -std::sin(a.z), std::cos(a.z), 0, 0, 0, 1);
  return z * y * x;
}

Technique probeTechnique(const Probe& probe) {
  const Technique technique = parseTechnique(probe.technique).value_or(Technique{});
  return probe.projection ? technique : withoutProjection(technique);
}

ProbeGeometry probeGeometry(const Probe& probe, const glm::dvec3& capturedAt, const glm::dvec3& capturedRotation) {
  ProbeGeometry g;
  g.originWorld = capturedAt;
  g.rotated = probe.rotationDegrees != glm::dvec3(0.0);
  g.worldFromProbe = g.rotated ? rotationMatrix(probe.rotationDegrees) : glm::dmat3(1.0);
  g.mapTurned = capturedRotation != probe.rotationDegrees;
  if (g.mapTurned) g.mapFromProbe = glm::transpose(rotationMatrix(capturedRotation)) * g.worldFromProbe;
  // The box rotates about its centre, so the origin in the box's own, unrotated coordinates is centre + R^T (C -
  // centre). Subtracting it makes everything relative to C before anything is rounded to float.
  const glm::dvec3 center = probe.box.center();
  const glm::dvec3 origin = g.rotated ? center + glm::transpose(g.worldFromProbe) * (capturedAt - center) : capturedAt;
  const Box& influence = probe.influenceBox();
  g.boxMin = glm::vec3(probe.box.min - origin);
  g.boxMax = glm::vec3(probe.box.max - origin);
  const double skin = skinOf(influence);
  g.influenceMin = glm::vec3(influence.min - skin - origin);
  g.influenceMax = glm::vec3(influence.max + skin - origin);
  // At least as wide as a position's rounding error; on screen it is still a step.
  const double shortest = std::max(kNarrowestBlend * largestSide(influence), 1.0e-30);  // a box may be a point
  g.rateMin = glm::vec3(1.0 / glm::max(probe.blendDistance.min, glm::dvec3(shortest)));
  g.rateMax = glm::vec3(1.0 / glm::max(probe.blendDistance.max, glm::dvec3(shortest)));
  g.intensity = static_cast<float>(probe.intensity);
  g.importance = probe.importance;
  if (probe.bevel) {
    g.bevelled = true;
    g.bevelRadius = static_cast<float>(probe.bevel->radius);
    g.bevelFromRoughness = static_cast<float>(probe.bevel->fromRoughness);
  }
  if (probe.occlusion) {
    g.occluded = true;
    g.occlusion = glm::vec3(probe.occlusion->multiplier, probe.occlusion->power, probe.occlusion->strength);
  }
  g.technique = probeTechnique(probe);
  g.parameters = techniqueParameters(probe);
  if (isAutomatic(g.technique)) {
    // `auto` was measured with default parameters: those that the scene keeps for other techniques do not affect what
    // it chooses.
    const float budget = g.parameters.budget;
    g.parameters = standardParameters();
    g.parameters.budget = budget;
  }
  for (const ParameterRow* row : parametersOf(g.technique)) {
    if (row->name == "animated") g.animated = parameterNumber(probe, *row) != 0.0;
    if (row->name == "blur") g.blurred = parameterNumber(probe, *row) != 0.0;
  }
  return g;
}

shading::ProbeShape probeShape(const ProbeGeometry& geometry, float maxLevel, float roughness) {
  shading::ProbeShape shape{};
  shape.boxMin = geometry.boxMin;
  shape.boxMax = geometry.boxMax;
  shape.maxLevel = maxLevel;
  shape.projection = geometry.technique.projection;
  shape.bevel = geometry.bevelled ? geometry.bevelRadius + geometry.bevelFromRoughness * roughness : 0.0f;
  shape.parameters = geometry.parameters;
  return shape;
}

bool fullWeightEverywhere(const Probe& probe, const Box& boundsWorld) {
  const Box& influence = probe.influenceBox();
  const glm::dvec3 center = probe.box.center();
  const glm::dmat3 probeFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 low = influence.min + probe.blendDistance.min;
  const glm::dvec3 high = influence.max - probe.blendDistance.max;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 world((corner & 1) != 0 ? boundsWorld.max.x : boundsWorld.min.x,
                           (corner & 2) != 0 ? boundsWorld.max.y : boundsWorld.min.y,
                           (corner & 4) != 0 ? boundsWorld.max.z : boundsWorld.min.z);
    const glm::dvec3 p = center + probeFromWorld * (world - center);
    if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) return false;
  }
  return true;
}

Box influenceBounds(const Probe& probe) {
  const Box& influence = probe.influenceBox();
  const glm::dvec3 center = probe.box.center();
  const glm::dmat3 r = rotationMatrix(probe.rotationDegrees);
  const glm::dvec3 middle = center + r * (influence.center() - center);
  const glm::dvec3 half = 0.5 * influence.size() + skinOf(influence);
  const glm::dvec3 extent = glm::abs(r[0]) * half.x + glm::abs(r[1]) * half.y + glm::abs(r[2]) * half.z;
  return Box{middle - extent, middle + extent};
}

}  // namespace boxprobe
