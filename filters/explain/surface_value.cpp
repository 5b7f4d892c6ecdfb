#include "filters/explain/surface_value.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/picture/probe_color.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

using Value = std::optional<glm::vec3>;

constexpr float kDarkest = 1e-20f, kLargestError = 1e4f;  // of relative errors: where there is no light

const ProbeExplanation* dominant(const Explanation& e) {
  return e.hit && e.dominant >= 0 ? &e.probes[static_cast<std::size_t>(e.dominant)] : nullptr;
}

Value scalar(float x) {
  return glm::vec3(x);
}

Value hitDistance(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  return p != nullptr && p->hitDistance ? scalar(*p->hitDistance) : std::nullopt;
}

Value trueDistance(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  return p != nullptr && p->trueDistance ? scalar(*p->trueDistance) : std::nullopt;
}

Value hitError(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  if (p == nullptr || !p->hitDistance || !p->trueDistance) return std::nullopt;
  return scalar(std::abs(*p->hitDistance - *p->trueDistance));
}

// The angle at the capture origin between the sampled direction and the correct one.
Value directionError(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  if (p == nullptr || !p->trueDistance) return std::nullopt;
  const glm::vec3 truth = p->positionProbe + *p->trueDistance * p->reflectionProbe;
  const glm::vec3 a = glm::normalize(p->lookupDirection), b = glm::normalize(truth);
  // From the sine as well: the cosine alone has no precision at small angles.
  return scalar(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.2957795f);
}

std::optional<float> meanLevel(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  if (p == nullptr || p->lookups.empty()) return std::nullopt;
  float sum = 0.0f;
  for (const Lookup& lookup : p->lookups) sum += lookup.level;
  return sum / static_cast<float>(p->lookups.size());
}

Value level(const Explanation& e) {
  const auto mean = meanLevel(e);
  return mean ? scalar(*mean) : std::nullopt;
}

Value effectiveRoughness(const Explanation& e) {
  const auto mean = meanLevel(e);
  return mean ? scalar(shading::roughnessForLevel(*mean, dominant(e)->maxLevel)) : std::nullopt;
}

Value lookupDirection(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  if (p == nullptr) return std::nullopt;
  return 0.5f * glm::normalize(glm::mat3(p->worldFromProbe) * p->lookupDirection) + 0.5f;
}

Value weights(const Explanation& e) {
  if (!e.hit || (e.probes.empty() && e.skyWeight == 0.0f)) return std::nullopt;
  glm::vec3 sum = e.skyWeight * skyColor();
  for (const ProbeExplanation& p : e.probes) sum += p.weight * probeColor(p.index);
  return sum;
}

Value face(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  return p != nullptr && p->face >= 0 ? scalar(static_cast<float>(p->face)) : std::nullopt;
}

Value lookups(const Explanation& e) {
  return e.hit ? scalar(static_cast<float>(e.lookupCount)) : std::nullopt;
}

Value picture(const Explanation& e) {
  return e.hit ? Value(e.color) : std::nullopt;
}

Value diffuseLight(const Explanation& e) {
  return e.hit ? e.irradiance : std::nullopt;
}

Value nodeValidity(const Explanation& e) {
  float share = 0.0f, known = 0.0f;
  for (const ProbeExplanation& p : e.probes) {
    if (!e.irradiance || p.diffuse.nodes.empty()) continue;
    share += p.weight;
    known += p.weight * p.diffuse.known;
  }
  return share > 0.0f ? scalar(known / share) : std::nullopt;
}

// What noise alone explains is no error.
Value diffuseError(const Explanation& e) {
  if (!e.hit || !e.irradiance || !e.tracedIrradiance) return std::nullopt;
  const glm::vec3 traced(*e.tracedIrradiance);
  const glm::vec3 off = *e.irradiance - traced;
  const float squares = std::max(glm::dot(off, off) - e.tracedIrradiance->w, 0.0f);
  return scalar(std::min(std::sqrt(squares / std::max(glm::dot(traced, traced), kDarkest)), kLargestError));
}

struct ViewValue {
  std::string_view id;
  Value (*value)(const Explanation&);
};

constexpr ViewValue kValues[] = {
    {"picture", picture},
    {"hit-distance", hitDistance},
    {"true-distance", trueDistance},
    {"hit-error", hitError},
    {"direction-error", directionError},
    {"level", level},
    {"roughness", effectiveRoughness},
    {"direction", lookupDirection},
    {"weights", weights},
    {"face", face},
    {"lookups", lookups},
    {"diffuse-light", diffuseLight},
    {"node-validity", nodeValidity},
    {"diffuse-error", diffuseError},
};

}  // namespace

std::optional<glm::vec3> surfaceValue(const SurfaceViewRow& row, const Explanation& e) {
  for (const ViewValue& known : kValues) {
    if (known.id == row.id) return known.value(e);
  }
  return std::nullopt;
}

}  // namespace boxprobe
