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

std::string metres(double length) {
  return fixedText(length, 2) + " m";
}

Phrase degrees(double angle) {
  if (angle < 0.1) return Phrase::tr("less than 0.1 degrees");
  return Phrase::tr("%1 degrees").arg(fixedText(angle, angle < 10.0 ? 1 : 0));
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
  std::vector<Phrase> parts;
  for (int face = 0; face < 6; ++face) {
    const double by = blendAt(*reach.probe, face) - reach.inside[static_cast<std::size_t>(face)];
    if (by <= 0.0) continue;
    (face % 2 == 1 ? influence.max : influence.min)[face / 2] += face % 2 == 1 ? by : -by;
    parts.push_back(Phrase::tr("%1 at %2").arg(metres(by)).arg(boxFaceName(face)));
  }
  const glm::dvec3 grown = influence.size() - size;
  if (parts.empty() || std::max({grown.x, grown.y, grown.z}) > std::max({size.x, size.y, size.z})) return std::nullopt;
  mend.after.influence = influence;
  mend.words = Phrase::tr("Widen the influence box of \"%1\": %2").arg(mend.probe).arg(commaList(parts));
  return mend;
}

Phrase facesWhere(const Reach& reach, double least) {
  Phrase names;
  for (int face = 0; face < 6; ++face) {
    const double inside = reach.inside[static_cast<std::size_t>(face)];
    const bool meant = least < 0.0 ? inside < 0.0 : inside < blendAt(*reach.probe, face);
    if (!meant) continue;
    const Phrase name = Phrase::plain(boxFaceName(face));
    names = names.empty() ? name : Phrase::tr("%1 and %2").arg(names).arg(name);
  }
  return names;
}

Verdict ofTheSky(const Explanation& e, const Scene& scene) {
  const Phrase sky = e.skyWeight > 0.995f || e.dominant < 0
                         ? Phrase::tr("The sky")
                         : Phrase::tr("The sky, at %1").arg(percent(double(e.skyWeight)));
  if (scene.probes.empty()) return {Phrase::tr("%1: the scene has no probe.").arg(sky), {}};
  const auto object = scene.objects.find(e.surface.object);
  if (object != scene.objects.end() && object->second.probeUsage == ProbeUsage::Off) {
    return {Phrase::tr("%1, because the probeMode of \"%2\" is off.").arg(sky).arg(e.surface.object), {}};
  }
  Reach nearest;
  for (const Probe& probe : scene.probes) {
    const Reach reach = reachOf(probe, e.surface.positionWorld);
    const bool nearer = nearest.probe == nullptr || reach.outside < nearest.outside;
    if (nearer) nearest = reach;
  }
  const std::string& name = nearest.probe->name;
  if (nearest.outside > 0.0) {
    const Phrase sentence =
        scene.probes.size() > 1
            ? Phrase::tr(
                  "%1, because every influence box ends short of this point; the nearest, of \"%2\", by %3 at %4.")
            : Phrase::tr("%1, because the influence box of \"%2\" ends %3 short of this point at %4.");
    return {sentence.arg(sky).arg(name).arg(metres(nearest.outside)).arg(facesWhere(nearest, -1.0)), widened(nearest)};
  }
  if (e.probes.empty()) return {Phrase::tr("%1: no probe lights this object.").arg(sky), {}};
  return {Phrase::tr("%1, because this point lies in the blend distance of \"%2\" at %3.")
              .arg(sky)
              .arg(name)
              .arg(facesWhere(nearest, 0.0)),
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
  const Phrase words = out > 0.0 ? Phrase::tr("Move the %1 face of \"%2\" out by %3")
                                 : Phrase::tr("Move the %1 face of \"%2\" in by %3");
  Mend mend{words.arg(boxFaceName(p.face)).arg(p.name).arg(metres(std::abs(out))), p.name, probe};
  setBox(mend.after, withFaceMoved(probe.box, probe.rotationDegrees, face, out, false, kMinimumThickness));
  return mend;
}

std::optional<Mend> boxProjected(const ProbeExplanation& p, const Probe& probe, double error) {
  const std::optional<double> left = errorWith(glm::dvec3(p.boxMin), glm::dvec3(p.boxMax), p);
  auto technique = parseTechnique(probe.technique);
  if (!left || !technique || *left > kWorthwhile * error) return std::nullopt;
  Mend mend{Phrase::tr("Project the lookups of \"%1\" on its box").arg(p.name), p.name, probe};
  mend.after.projection = true;
  const Technique box = *parseTechnique("box");
  if (probeTechnique(mend.after) == withoutProjection(probeTechnique(mend.after))) {
    technique->projection = box.projection;
    mend.after.technique = shortTechniqueId(*technique);
  }
  return mend;
}

Verdict ofProbe(const ProbeExplanation& p, const Probe& probe) {
  const Phrase who = p.weight > 0.995f ? Phrase::tr("Probe \"%1\"").arg(p.name)
                                       : Phrase::tr("Probe \"%1\", at %2").arg(p.name).arg(percent(double(p.weight)));
  if (!p.captured) return {Phrase::tr("%1: not captured yet, so it reflects nothing.").arg(who), {}};
  if (p.coverage && *p.coverage < 0.5f) {
    return {Phrase::tr("%1: it captured nothing in this direction, so the sky shows through it.").arg(who), {}};
  }
  if (!p.trueDistance) {
    return {Phrase::tr("%1: its capture origin does not see where this ray ends, so its error is unknown.").arg(who),
            {}};
  }
  const double error = degreesBetween(glm::dvec3(p.lookupDirection), trueDirection(p));
  if (error < kRightDegrees) return {Phrase::tr("%1, right to %2.").arg(who).arg(degrees(error)), {}};
  if (!p.hitDistance) {
    return {Phrase::tr("%1, %2 off: it is sampled by the reflection vector alone, without a hit point.")
                .arg(who)
                .arg(degrees(error)),
            boxProjected(p, probe, error)};
  }
  const double behind = double(*p.trueDistance) - double(*p.hitDistance);
  const Phrase hit =
      p.face >= 0 ? Phrase::tr("the %1 face of its box").arg(boxFaceName(p.face)) : Phrase::tr("its proxy");
  const Phrase sentence = behind > 0.0
                              ? Phrase::tr("%1, %2 off: the ray meets %3 %4 before the surface that is there.")
                              : Phrase::tr("%1, %2 off: the ray meets %3 %4 behind the surface that is there.");
  return {sentence.arg(who).arg(degrees(error)).arg(hit).arg(metres(std::abs(behind))), movedFace(p, probe, error)};
}

// Other sources of light, if reflections are a small part; otherwise empty.
Phrase notReflected(const Explanation& e) {
  const double all = brightness(e.color);
  if (all <= 0.0) return {};
  const double reflected = brightness(e.specular + e.coat);
  if (reflected >= 0.1 * all) return {};
  struct Part {
    double light;
    Phrase name;
  };
  const Part parts[] = {{brightness(e.direct), Phrase::tr("the light sources")},
                        {brightness(e.emissive), Phrase::tr("the surface itself")},
                        {brightness(e.diffuse), Phrase::tr("light from all around, scattered")}};
  const Part& most = *std::max_element(std::begin(parts), std::end(parts),
                                       [](const Part& a, const Part& b) { return a.light < b.light; });
  return Phrase::tr("Hardly a reflection: %1 of this light is from %2, %3 is reflected.")
      .arg(percent(most.light / all))
      .arg(most.name)
      .arg(percent(reflected / all));
}

}  // namespace

Verdict verdictOf(const Explanation& e, const Scene& scene) {
  if (!e.hit) return {Phrase::tr("The background: no surface is drawn here."), {}};
  if (e.glass) {
    const double all = brightness(e.color);
    return {Phrase::tr("Glass: %1 of this light came through it.")
                .arg(percent(all > 0.0 ? brightness(e.glass->light()) / all : 0.0)),
            {}};
  }
  if (e.mirror && e.mirror->coverage > 0.5f) {
    return {Phrase::tr("The planar mirror's own picture: something that moves takes %1 of the reflection.")
                .arg(percent(double(e.mirror->coverage))),
            {}};
  }
  Verdict verdict;
  const Phrase otherwise = notReflected(e);
  if (e.skyWeight >= 0.5f || e.dominant < 0) {
    verdict = ofTheSky(e, scene);
  } else {
    const ProbeExplanation& p = e.probes[static_cast<std::size_t>(e.dominant)];
    verdict = ofProbe(p, scene.probes[static_cast<std::size_t>(p.index)]);
  }
  if (!otherwise.empty()) verdict.sentence = Phrase::tr("%1 %2").arg(otherwise).arg(verdict.sentence);
  return verdict;
}

}  // namespace boxprobe
