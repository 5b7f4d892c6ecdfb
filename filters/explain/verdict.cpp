// See verdict.h.
#include "filters/explain/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "filters/core/base/fixed_text.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/explain/explanation_rows.h"

namespace boxprobe {

namespace {

using explained::percent;

/// Below this angle a lookup counts as right: the difference is invisible in a mirror.
constexpr double kRightDegrees = 1.0;
/// An edit is offered if at most this share of the error at the pixel remains.
constexpr double kWorthwhile = 0.5;
/// Faces are moved by at most this share of the box: a surface farther away is not a wall of this box.
constexpr double kLargestMove = 0.5;

double brightness(const glm::vec3& light) {
  return 0.2126 * double(light.x) + 0.7152 * double(light.y) + 0.0722 * double(light.z);
}

std::string inQuotes(const std::string& name) {
  return "\"" + name + "\"";
}

std::string metres(double length) {
  return fixedText(length, 2) + " m";
}

std::string degrees(double angle) {
  if (angle < 0.1) return "less than 0.1 degrees";
  return fixedText(angle, angle < 10.0 ? 1 : 0) + " degrees";
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

BoxFace faceOf(int face) {
  return {face / 2, face % 2 == 1};
}

// The position of a point relative to an influence box: by face, in the order of explanations (-x +x -y ...), metres.
struct Reach {
  const Probe* probe = nullptr;
  std::array<double, 6> inside{};  ///< distance to the face; negative outside
  double outside = 0.0;            ///< distance from the box; 0 inside
};

double blendAt(const Probe& probe, int face) {
  return face % 2 == 1 ? probe.blendDistance.max[face / 2] : probe.blendDistance.min[face / 2];
}

Reach reachOf(const Probe& probe, const glm::dvec3& pointWorld) {
  const glm::dvec3 center = probe.box.center();
  const glm::dvec3 point = center + glm::transpose(rotationMatrix(probe.rotationDegrees)) * (pointWorld - center);
  const Box& box = probe.influenceBox();
  Reach reach;
  reach.probe = &probe;
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto low = static_cast<std::size_t>(2 * axis);
    reach.inside[low] = point[axis] - box.min[axis];
    reach.inside[low + 1] = box.max[axis] - point[axis];
    const double beyond = std::max({-reach.inside[low], -reach.inside[low + 1], 0.0});
    square += beyond * beyond;
  }
  reach.outside = std::sqrt(square);
  return reach;
}

// Widens the influence box until the point has the probe's full weight; returns the edit with its description.
std::optional<Mend> widened(const Reach& reach) {
  Mend mend;
  mend.probe = reach.probe->name;
  mend.after = *reach.probe;
  Box influence = reach.probe->influenceBox();
  const glm::dvec3 size = influence.size();
  std::string parts;
  for (int face = 0; face < 6; ++face) {
    const double by = blendAt(*reach.probe, face) - reach.inside[static_cast<std::size_t>(face)];
    if (by <= 0.0) continue;
    (face % 2 == 1 ? influence.max : influence.min)[face / 2] += face % 2 == 1 ? by : -by;
    parts += (parts.empty() ? "" : ", ") + metres(by) + " at " + boxFaceName(face);
  }
  const glm::dvec3 grown = influence.size() - size;
  if (parts.empty() || std::max({grown.x, grown.y, grown.z}) > std::max({size.x, size.y, size.z})) return std::nullopt;
  mend.after.influence = influence;
  mend.words = "Widen the influence box of " + inQuotes(mend.probe) + ": " + parts;
  return mend;
}

std::string facesWhere(const Reach& reach, double least) {
  std::string names;
  for (int face = 0; face < 6; ++face) {
    const double inside = reach.inside[static_cast<std::size_t>(face)];
    const bool meant = least < 0.0 ? inside < 0.0 : inside < blendAt(*reach.probe, face);
    if (meant) names += (names.empty() ? "" : " and ") + boxFaceName(face);
  }
  return names;
}

Verdict ofTheSky(const Explanation& e, const Scene& scene) {
  const std::string sky =
      e.skyWeight > 0.995f || e.dominant < 0 ? "The sky" : "The sky, at " + percent(double(e.skyWeight));
  if (scene.probes.empty()) return {sky + ": the scene has no probe.", {}};
  const auto object = scene.objects.find(e.surface.object);
  if (object != scene.objects.end() && object->second.probeUsage == ProbeUsage::Off) {
    return {sky + ", because the probeMode of " + inQuotes(e.surface.object) + " is off.", {}};
  }
  Reach nearest;
  for (const Probe& probe : scene.probes) {
    const Reach reach = reachOf(probe, e.surface.positionWorld);
    const bool nearer = nearest.probe == nullptr || reach.outside < nearest.outside;
    if (nearer) nearest = reach;
  }
  const std::string name = inQuotes(nearest.probe->name);
  if (nearest.outside > 0.0) {
    const bool several = scene.probes.size() > 1;
    return {sky + ", because " +
                (several ? "every influence box ends short of this point; the nearest, of " : "the influence box of ") +
                name + (several ? ", by " : " ends ") + metres(nearest.outside) +
                (several ? "" : " short of this point") + " at " + facesWhere(nearest, -1.0) + ".",
            widened(nearest)};
  }
  if (e.probes.empty()) return {sky + ": no probe lights this object.", {}};
  return {sky + ", because this point lies in the blend distance of " + name + " at " + facesWhere(nearest, 0.0) + ".",
          widened(nearest)};
}

// The hit in the captured distances, as seen from the capture origin.
glm::dvec3 trueDirection(const ProbeExplanation& p) {
  return glm::dvec3(p.positionProbe) + double(*p.trueDistance) * glm::dvec3(p.reflectionProbe);
}

// The error in degrees with a box of these bounds; nothing if the ray does not leave it forwards.
std::optional<double> errorWith(const glm::dvec3& low, const glm::dvec3& high, const ProbeExplanation& p) {
  double exit = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double along = double(p.reflectionProbe[axis]);
    if (along == 0.0) continue;
    exit = std::min(exit, ((along > 0.0 ? high : low)[axis] - double(p.positionProbe[axis])) / along);
  }
  if (!(exit > 0.0) || std::isinf(exit)) return std::nullopt;
  return degreesBetween(glm::dvec3(p.positionProbe) + exit * glm::dvec3(p.reflectionProbe), trueDirection(p));
}

std::optional<Mend> movedFace(const ProbeExplanation& p, const Probe& probe, double error) {
  if (p.face < 0 || !p.slabFactors) return std::nullopt;
  const BoxFace face = faceOf(p.face);
  glm::dvec3 low(p.boxMin), high(p.boxMax);
  double& plane = (face.positive ? high : low)[face.axis];
  const double out = (trueDirection(p)[face.axis] - plane) * face.sign();
  if (std::abs(out) > kLargestMove * probe.box.size()[face.axis]) return std::nullopt;
  plane += out * face.sign();
  // The capture origin, which is 0 here, must stay inside.
  if (low[face.axis] > -kMinimumThickness || high[face.axis] < kMinimumThickness) return std::nullopt;
  const std::optional<double> left = errorWith(low, high, p);
  if (!left || *left > kWorthwhile * error) return std::nullopt;
  Mend mend{"Move the " + boxFaceName(p.face) + " face of " + inQuotes(p.name) + (out > 0.0 ? " out by " : " in by ") +
                metres(std::abs(out)),
            p.name, probe};
  setBox(mend.after, withFaceMoved(probe.box, probe.rotationDegrees, face, out, false, kMinimumThickness));
  return mend;
}

std::optional<Mend> boxProjected(const ProbeExplanation& p, const Probe& probe, double error) {
  const std::optional<double> left = errorWith(glm::dvec3(p.boxMin), glm::dvec3(p.boxMax), p);
  auto technique = parseTechnique(probe.technique);
  if (!left || !technique || *left > kWorthwhile * error) return std::nullopt;
  Mend mend{"Project the lookups of " + inQuotes(p.name) + " on its box", p.name, probe};
  mend.after.projection = true;
  const Technique box = *parseTechnique("box");
  if (probeTechnique(mend.after) == withoutProjection(probeTechnique(mend.after))) {
    technique->projection = box.projection;
    mend.after.technique = shortTechniqueId(*technique);
  }
  return mend;
}

Verdict ofProbe(const ProbeExplanation& p, const Probe& probe) {
  const std::string who = "Probe " + inQuotes(p.name) + (p.weight > 0.995f ? "" : ", at " + percent(double(p.weight)));
  if (!p.captured) return {who + ": not captured yet, so it reflects nothing.", {}};
  if (p.coverage && *p.coverage < 0.5f) {
    return {who + ": it captured nothing in this direction, so the sky shows through it.", {}};
  }
  if (!p.trueDistance) {
    return {who + ": its capture origin does not see where this ray ends, so its error is unknown.", {}};
  }
  const double error = degreesBetween(glm::dvec3(p.lookupDirection), trueDirection(p));
  if (error < kRightDegrees) return {who + ", right to " + degrees(error) + ".", {}};
  if (!p.hitDistance) {
    return {who + ", " + degrees(error) + " off: it is sampled by the reflection vector alone, without a hit point.",
            boxProjected(p, probe, error)};
  }
  const double behind = double(*p.trueDistance) - double(*p.hitDistance);
  const std::string hit = p.face >= 0 ? "the " + boxFaceName(p.face) + " face of its box" : "its proxy";
  return {who + ", " + degrees(error) + " off: the ray meets " + hit + " " + metres(std::abs(behind)) +
              (behind > 0.0 ? " before" : " behind") + " the surface that is there.",
          movedFace(p, probe, error)};
}

// Other sources of light, if reflections are a small part; otherwise empty.
std::string notReflected(const Explanation& e) {
  const double all = brightness(e.color);
  if (all <= 0.0) return {};
  const double reflected = brightness(e.specular + e.coat);
  if (reflected >= 0.1 * all) return {};
  struct Part {
    double light;
    const char* name;
  };
  const Part parts[] = {{brightness(e.direct), "the light sources"},
                        {brightness(e.emissive), "the surface itself"},
                        {brightness(e.diffuse), "light from all around, scattered"}};
  const Part& most = *std::max_element(std::begin(parts), std::end(parts),
                                       [](const Part& a, const Part& b) { return a.light < b.light; });
  return "Hardly a reflection: " + percent(most.light / all) + " of this light is from " + most.name + ", " +
         percent(reflected / all) + " is reflected.";
}

}  // namespace

Verdict verdictOf(const Explanation& e, const Scene& scene) {
  if (!e.hit) return {"The background: no surface is drawn here.", {}};
  if (e.glass) {
    const double all = brightness(e.color);
    return {
        "Glass: " + percent(all > 0.0 ? brightness(e.glass->light()) / all : 0.0) + " of this light came through it.",
        {}};
  }
  if (e.mirror && e.mirror->coverage > 0.5f) {
    return {"The planar mirror's own picture: something that moves takes " + percent(double(e.mirror->coverage)) +
                " of the reflection.",
            {}};
  }
  Verdict verdict;
  const std::string otherwise = notReflected(e);
  if (e.skyWeight >= 0.5f || e.dominant < 0) {
    verdict = ofTheSky(e, scene);
  } else {
    const ProbeExplanation& p = e.probes[static_cast<std::size_t>(e.dominant)];
    verdict = ofProbe(p, scene.probes[static_cast<std::size_t>(p.index)]);
  }
  if (!otherwise.empty()) verdict.sentence = otherwise + " " + verdict.sentence;
  return verdict;
}

}  // namespace boxprobe
