#include "filters/core/surface_view.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/probe_color.h"
#include "filters/math/shared_math.h"

namespace boxprobe {

namespace {

using Value = std::optional<glm::vec3>;

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

// The angle, seen from the capture origin, between what is looked up and what should be.
Value directionError(const Explanation& e) {
  const ProbeExplanation* p = dominant(e);
  if (p == nullptr || !p->trueDistance) return std::nullopt;
  const glm::vec3 truth = p->positionProbe + *p->trueDistance * p->reflectionProbe;
  const glm::vec3 a = glm::normalize(p->lookupDirection), b = glm::normalize(truth);
  // By the sine as well: the cosine alone has no digits left at small angles.
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

}  // namespace

// The order is the shader's: shaders/gpu/surface_view.glsl switches on the row's index.
const std::vector<SurfaceViewRow>& surfaceViews() {
  static const std::vector<SurfaceViewRow> rows = {
      {"picture", "Picture", "", "The surfaces as they are.", ViewKind::Picture, 0, 1,
       [](const Explanation& e) { return e.hit ? Value(e.color) : std::nullopt; }},
      {"hit-distance", "Hit distance", "scene units",
       "From the surface along the reflected ray to where it leaves the probe's proxy: the d of the projection.",
       ViewKind::Scalar, 0, 0, hitDistance},
      {"true-distance", "True distance", "scene units",
       "Along the reflected ray to what the probe's distance cubemap holds there.", ViewKind::Scalar, 0, 0,
       trueDistance},
      {"hit-error", "Hit error", "scene units",
       "Between the proxy's hit and the true one: 0 where the scene is the box.", ViewKind::Scalar, 0, 0, hitError},
      {"direction-error", "Lookup error", "degrees",
       "Seen from the capture origin, the angle between the direction looked up and the one to the true hit.",
       ViewKind::Scalar, 0, 30, directionError},
      {"level", "Level", "", "The level of the prefiltered chain that is fetched; a mean if there are several fetches.",
       ViewKind::Scalar, 0, 0, level},
      {"roughness", "Effective roughness", "",
       "The roughness that level was baked for: what the technique makes of it.", ViewKind::Scalar, 0, 1,
       effectiveRoughness},
      {"direction", "Lookup direction", "", "The direction looked up, x y z from -1 to 1 as red, green and blue.",
       ViewKind::Color, 0, 1, lookupDirection},
      {"weights", "Probe weights", "", "Each probe's colour by its share of the pixel; dark grey is the sky's share.",
       ViewKind::Color, 0, 1, weights},
      {"face", "Face hit", "", "The face of the box that the reflected ray hits: -x +x -y +y -z +z.",
       ViewKind::Category, 0, 5, face},
      {"lookups", "Lookups", "", "Fetches from cubemaps at this pixel.", ViewKind::Scalar, 0, 8, lookups},
  };
  return rows;
}

std::optional<int> findSurfaceView(std::string_view id) {
  const auto& rows = surfaceViews();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].id == id) return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace boxprobe
