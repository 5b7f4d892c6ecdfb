// See schematic.h.
#include "filters/explain/schematic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

#include "filters/core/base/fixed_text.h"
#include "filters/explain/explanation_rows.h"

namespace boxprobe {

namespace {

constexpr int kDecimals = 2;
constexpr char kAxisLetters[] = "xyz";

/// What both views show, in the probe's frame.
struct Ray {
  glm::dvec3 position, reflection, normal, view;
  glm::dvec3 eye;
  double eyeDistance;
  glm::dvec3 boxMin, boxMax;
  bool hasBox = false;
  std::optional<glm::dvec3> hit, trueHit;
  glm::dvec3 lookup;
  std::optional<glm::vec3> slab;
  double reach = 1.0;  ///< a suitable length for drawings: half of the box's size
};

Ray rayOf(const Explanation& e, const ProbeExplanation& p) {
  const glm::dmat3 probeFromWorld = glm::transpose(p.worldFromProbe);
  Ray r;
  r.position = p.positionProbe;
  r.reflection = p.reflectionProbe;
  r.normal = probeFromWorld * glm::dvec3(e.surface.normalWorld);
  r.view = probeFromWorld * glm::dvec3(e.surface.viewWorld);
  r.eyeDistance = glm::length(e.surface.eyeWorld - e.surface.positionWorld);
  r.eye = r.position + r.eyeDistance * r.view;
  r.boxMin = p.boxMin;
  r.boxMax = p.boxMax;
  r.hasBox = p.slabFactors.has_value();
  r.slab = p.slabFactors;
  // The hit as the lookup uses it: moved onto the box if P is outside.
  if (p.hitDistance) r.hit = glm::dvec3(p.lookupDirection);
  if (p.trueDistance) r.trueHit = r.position + static_cast<double>(*p.trueDistance) * r.reflection;
  r.lookup = p.lookupDirection;
  const double size = glm::length(r.boxMax - r.boxMin);
  r.reach = 0.3 * (size > 0.0 ? size : std::max(glm::length(r.position), 1.0));
  return r;
}

int smallestAxis(const glm::vec3& t) {
  return t.x <= t.y && t.x <= t.z ? 0 : t.y <= t.z ? 1 : 2;
}

/// The ray's length inside the box, whether or not the technique uses the box; without a box, a suitable length.
double wayOut(const Ray& r, const glm::dvec3& from, const glm::dvec3& along) {
  double way = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0.0) continue;
    const double wall = along[axis] > 0.0 ? r.boxMax[axis] : r.boxMin[axis];
    way = std::min(way, (wall - from[axis]) / along[axis]);
  }
  return std::isfinite(way) && way > 0.0 ? way : r.reach;
}

class ViewBuilder {
 public:
  ViewBuilder(Phrase title, int right, int up, bool rightFlipped, bool upFlipped) {
    view_.title = std::move(title);
    view_.right = right;
    view_.up = up;
    view_.rightFlipped = rightFlipped;
    view_.upFlipped = upFlipped;
  }

  glm::dvec2 paper(const glm::dvec3& p) const {
    return {view_.rightFlipped ? -p[view_.right] : p[view_.right], view_.upFlipped ? -p[view_.up] : p[view_.up]};
  }

  SchematicView build(const Ray& r) {
    see(paper(r.position));
    see(paper(glm::dvec3(0.0)));
    if (r.hit) see(paper(*r.hit));
    if (r.trueHit) see(paper(*r.trueHit));
    if (r.hasBox) addBox(r);
    addLines(r);
    if (r.slab) addPlanes(r);
    addPoints(r);
    return view_;
  }

  /// The view of an inset; see insetView.
  SchematicView buildInset(const Ray& r) {
    if (r.boxMax != r.boxMin) addBox(r);
    view_.boxUsed = r.hasBox;
    const glm::dvec3 none(0.0);
    for (const glm::dvec3& p : {r.position, none, r.hit.value_or(none), r.trueHit.value_or(none)}) see(paper(p));
    // An eye far away would shrink the drawing: its line leaves the paper instead.
    const glm::dvec2 size = view_.high - view_.low;
    see(glm::clamp(paper(r.eye), view_.low - 0.5 * size, view_.high + 0.5 * size));
    const auto line = [&](SchematicLine kind, const glm::dvec3& from, const glm::dvec3& to, const char* label) {
      view_.lines.push_back({kind, paper(from), paper(to), label, 1.0});
    };
    const auto point = [&](SchematicPoint kind, const glm::dvec3& at, explained::Symbol label) {
      view_.points.push_back({kind, paper(at), std::move(label), {}});
    };
    line(SchematicLine::Eye, r.eye, r.position, "");
    if (r.hit) {
      line(SchematicLine::Lookup, none, *r.hit, "H - C");
      line(SchematicLine::Reflected, r.position, *r.hit, "R");
      point(SchematicPoint::Hit, *r.hit, "H");
    } else {
      const glm::dvec3 met = r.trueHit.value_or(r.position + wayOut(r, r.position, r.reflection) * r.reflection);
      const glm::dvec3 lookup = glm::normalize(r.lookup);
      line(SchematicLine::Lookup, none, wayOut(r, none, lookup) * lookup, "R");
      line(SchematicLine::Reflected, r.position, met, "R");
    }
    const double visible = 0.02 * glm::length(r.boxMax - r.boxMin);
    if (r.hit && r.trueHit && glm::length(*r.trueHit - *r.hit) > visible) {
      line(SchematicLine::TrueHit, *r.hit, *r.trueHit, "");
      point(SchematicPoint::TrueHit, *r.trueHit, Phrase::tr("true"));
    }
    point(SchematicPoint::Shading, r.position, "P");
    point(SchematicPoint::Origin, none, "C");
    point(SchematicPoint::Eye, r.eye, Phrase::tr("eye"));
    for (auto& shown : view_.points) shown.labelDirection = freeDirection(shown.at);
    return view_;
  }

 private:
  void see(const glm::dvec2& p) {
    view_.low = seen_ ? glm::min(view_.low, p) : p;
    view_.high = seen_ ? glm::max(view_.high, p) : p;
    seen_ = true;
  }

  void addBox(const Ray& r) {
    const glm::dvec2 a = paper(r.boxMin), b = paper(r.boxMax);
    view_.boxLow = glm::min(a, b);
    view_.boxHigh = glm::max(a, b);
    see(a);
    see(b);
  }

  void addLines(const Ray& r) {
    const auto line = [&](SchematicLine kind, const glm::dvec3& from, const glm::dvec3& to, const char* label) {
      const double inSpace = glm::length(to - from), onPaper = glm::length(paper(to) - paper(from));
      view_.lines.push_back({kind, paper(from), paper(to), label, inSpace > 0.0 ? onPaper / inSpace : 0.0});
    };
    line(SchematicLine::Eye, r.eye, r.position, "");
    if (r.hit) {
      line(SchematicLine::Lookup, glm::dvec3(0.0), *r.hit, "H - C");
      line(SchematicLine::Reflected, r.position, *r.hit, "d");
    } else {
      // A direction has no length: it is drawn with a suitable one.
      line(SchematicLine::Lookup, glm::dvec3(0.0), r.reach * glm::normalize(r.lookup), "L");
      line(SchematicLine::Reflected, r.position, r.position + r.reach * r.reflection, "");
    }
    line(SchematicLine::Normal, r.position, r.position + 0.5 * r.reach * r.normal, "");
    if (r.trueHit && r.hit) line(SchematicLine::TrueHit, *r.hit, *r.trueHit, "");
  }

  /// For the planes that this view shows edge-on: where the extended ray crosses each.
  void addPlanes(const Ray& r) {
    const int smallest = smallestAxis(*r.slab);
    for (const int axis : {view_.right, view_.up}) {
      constexpr double kFarBoxes = 100.0;  // for a ray all but parallel to the plane
      const double t = (*r.slab)[axis];
      if (t > kFarBoxes * glm::length(r.boxMax - r.boxMin)) continue;
      glm::dvec3 from = r.boxMin, to = r.boxMax;
      const double plane = r.reflection[axis] > 0.0 ? r.boxMax[axis] : r.boxMin[axis];
      from[axis] = to[axis] = plane;
      glm::dvec3 crossing = r.position + t * r.reflection;
      if (axis == smallest && r.hit) crossing = *r.hit;
      const std::string label = std::string("t_") + kAxisLetters[axis] + " = " + fixedText(t, kDecimals);
      // The third axis of `from` and `to` is perpendicular to the paper.
      glm::dvec2 a = paper(from), b = paper(to);
      view_.planes.push_back({a, b, paper(crossing), label, axis == smallest});
      if (axis == smallest) continue;
      view_.lines.push_back({SchematicLine::Slab, paper(r.hit.value_or(r.position)), paper(crossing), "", 1.0});
      view_.points.push_back({SchematicPoint::SlabPlane, paper(crossing), Phrase::plain(label), {}});
      // A distant crossing would shrink the drawing: its line leaves the paper instead.
      constexpr double kRoom = 0.4;
      const glm::dvec2 room = kRoom * (*view_.boxHigh - *view_.boxLow);
      see(glm::clamp(paper(crossing), *view_.boxLow - room, *view_.boxHigh + room));
    }
  }

  void addPoints(const Ray& r) {
    const auto add = [&](SchematicPoint kind, const glm::dvec3& at, explained::Symbol label) {
      view_.points.push_back({kind, paper(at), std::move(label), {}});
    };
    add(SchematicPoint::Shading, r.position, "P");
    add(SchematicPoint::Origin, glm::dvec3(0.0), "C");
    if (r.hit) add(SchematicPoint::Hit, *r.hit, "H");
    if (r.trueHit) add(SchematicPoint::TrueHit, *r.trueHit, "");
    add(SchematicPoint::Eye, r.eye, Phrase::tr("eye"));
    for (auto& point : view_.points) point.labelDirection = freeDirection(point.at);
  }

  /// Of eight directions, the one with the largest angle to every line that leaves `at` and to nearby points.
  glm::dvec2 freeDirection(const glm::dvec2& at) const {
    const double near = 1e-6 * (glm::length(view_.high - view_.low) + 1e-30);
    std::vector<glm::dvec2> taken;
    const auto take = [&](const glm::dvec2& other) {
      const glm::dvec2 away = other - at;
      if (glm::length(away) > near) taken.push_back(glm::normalize(away));
    };
    for (const auto& line : view_.lines) {
      if (glm::length(line.from - at) <= near) take(line.to);
      if (glm::length(line.to - at) <= near) take(line.from);
    }
    for (const auto& plane : view_.planes) {
      if (glm::length(plane.crossing - at) > near) continue;
      take(plane.from);
      take(plane.to);
    }
    glm::dvec2 best(0.0, 1.0);
    double bestCosine = 2.0;
    constexpr double kDiagonal = 0.7071067811865476;
    // Diagonals first: box edges and many rays are parallel to the axes.
    static const std::array<glm::dvec2, 8> directions = {glm::dvec2(kDiagonal, kDiagonal),
                                                         {-kDiagonal, kDiagonal},
                                                         {kDiagonal, -kDiagonal},
                                                         {-kDiagonal, -kDiagonal},
                                                         glm::dvec2(0.0, 1.0),
                                                         {1.0, 0.0},
                                                         {0.0, -1.0},
                                                         {-1.0, 0.0}};
    for (const glm::dvec2& direction : directions) {
      double cosine = -1.0;
      for (const glm::dvec2& other : taken) cosine = std::max(cosine, glm::dot(direction, other));
      if (cosine < bestCosine - 1e-9) {
        bestCosine = cosine;
        best = direction;
      }
    }
    return best;
  }

  SchematicView view_;
  bool seen_ = false;
};

Phrase caption(const ProbeExplanation& p) {
  if (!p.hitDistance) return Phrase::tr("no box to hit: d and H are undefined");
  const std::string d = fixedText(*p.hitDistance, kDecimals);
  if (!p.slabFactors) return Phrase::plain("d = " + d);
  const auto t = [&](int axis) {
    const float value = (*p.slabFactors)[axis];
    return numberPhrase(value > 1e30f ? "infinite" : fixedText(value, kDecimals));
  };
  return Phrase::tr("d = min(t_x, t_y, t_z) = min(%1, %2, %3) = %4").arg(t(0)).arg(t(1)).arg(t(2)).arg(d);
}

/// The probe to draw; null: none.
const ProbeExplanation* drawnProbe(const Explanation& e) {
  if (!e.hit || e.surface.normalWorld == glm::vec3(0.0f) || e.probes.empty()) return nullptr;
  return &e.probes[static_cast<std::size_t>(std::max(e.dominant, 0))];
}

ViewBuilder planOf() {
  return {Phrase::tr("Plan (from above)"), 0, 2, false, true};
}

/// Looking along -z at the front (x to the right), or from the +x side (-z to the right).
ViewBuilder elevationOf(const Ray& r) {
  const bool alongX = std::abs(r.reflection.x) >= std::abs(r.reflection.z);
  return alongX ? ViewBuilder(Phrase::tr("Elevation (from the front)"), 0, 1, false, false)
                : ViewBuilder(Phrase::tr("Elevation (from the side)"), 2, 1, true, false);
}

}  // namespace

std::optional<Schematic> schematic(const Explanation& e) {
  const ProbeExplanation* p = drawnProbe(e);
  if (p == nullptr) return std::nullopt;
  const Ray r = rayOf(e, *p);
  return Schematic{planOf().build(r), elevationOf(r).build(r), caption(*p)};
}

std::optional<SchematicView> insetView(const Explanation& e, bool elevation) {
  const ProbeExplanation* p = drawnProbe(e);
  if (p == nullptr) return std::nullopt;
  const Ray r = rayOf(e, *p);
  return (elevation ? elevationOf(r) : planOf()).buildInset(r);
}

}  // namespace boxprobe
