// See exact_lamp.h.
#include "filters/stress/exact_lamp.h"

#include <algorithm>
#include <cmath>

namespace boxprobe::stress::exact {

namespace {

constexpr Real kTurn = 6.283185307179586476925L;
using Two = std::array<Real, 2>;

Vec sum(const Vec& a, const Vec& b, Real factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Vec times(Real factor, const Vec& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& a) {
  const Real size = length(a);
  return size > 0 ? times(1 / size, a) : a;
}
Two sum(const Two& a, const Two& b, Real factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1]};
}

// What of a polygon lies where `up` says, in order.
std::vector<Vec> above(const std::vector<Vec>& polygon, const Vec& up) {
  std::vector<Vec> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Real high = dot(a, up), next = dot(b, up);
    if (high >= 0) kept.push_back(a);
    if ((high >= 0) != (next >= 0)) kept.push_back(sum(a, sum(b, a, -1), high / (high - next)));
  }
  return kept;
}

// Angle between two directions times the unit normal of their plane.
Vec arc(const Vec& a, const Vec& b) {
  const Vec c = cross(a, b);
  const Real sine = length(c);
  return sine > 0 ? times(std::atan2(sine, dot(a, b)) / sine, c) : Vec{0, 0, 0};
}

std::vector<Vec> seenFrom(const Lamp& lamp, const Vec& position) {
  std::vector<Vec> corners;
  for (const Vec& corner : lamp.corners) corners.push_back(sum(corner, position, -1));
  return corners;
}

struct Facet {
  Vec normal;  // where the surface is stretched to roughness 1
  Real cosine;
  Two weight;
};

class Lobe {
 public:
  Lobe(const Vec& normal, const Vec& view, Real roughness) : normal_(normal) {
    const Real facing = dot(normal, view), nv = std::min(std::max(facing, 1.0e-4L), 1.0L);
    const Vec aside = sum(view, normal, -facing);
    tangent_ = length(aside) > 1.0e-4L ? unit(aside) : anyTangent(normal);
    bitangent_ = cross(normal, tangent_);
    view_ = unit({length(aside), 0, nv});
    const Real p = std::min(std::max(roughness, 0.03L), 1.0L);
    alpha_ = p * p;
    stretched_ = unit({alpha_ * view_[0], 0, view_[2]});
    spread_ = std::min(std::max(5 * (p - 0.15L), 0.0L), 1.0L);
  }

  Vec local(const Vec& v) const { return {dot(v, tangent_), dot(v, bitangent_), dot(v, normal_)}; }

  Facet ofLight(const Vec& l) const {
    const Vec h = sum(view_, Vec{l[0], l[1], std::max<Real>(l[2], 0)});
    const Vec normal = unit({h[0], h[1], alpha_ * h[2]});
    return {normal, std::max<Real>(dot(normal, stretched_), 0), weight(l[2], dot(view_, unit(h)))};
  }

  Facet ofNormal(const Vec& normal) const {
    const Vec h = unit({alpha_ * normal[0], alpha_ * normal[1], normal[2]});
    const Real cosine = dot(view_, h);
    return {normal, std::max<Real>(dot(normal, stretched_), 0), weight(2 * cosine * h[2] - view_[2], cosine)};
  }

  const Vec& view() const { return view_; }
  const Vec& stretched() const { return stretched_; }
  Real spread() const { return spread_; }

 private:
  static Vec anyTangent(const Vec& n) {
    const bool flat = std::abs(n[2]) < 0.9L;
    return unit(cross(flat ? Vec{0, 0, 1} : Vec{1, 0, 0}, n));
  }

  // Smith's height-correlated masking of both directions over that of the view, with Schlick's edge.
  Two weight(Real height, Real cosine) const {
    const Real light = std::max<Real>(height, 0), eye = view_[2], a2 = alpha_ * alpha_;
    if (light <= 0) return {0, 0};
    const auto lambda = [a2](Real z) { return (std::sqrt(1 + a2 * (1 - z * z) / (z * z)) - 1) / 2; };
    const Real masking = (1 + lambda(eye)) / (1 + lambda(eye) + lambda(light));
    const Real edge = std::pow(std::min(std::max(1 - cosine, 0.0L), 1.0L), 5.0L);
    return {masking * (1 - edge), masking * edge};
  }

  Vec normal_, tangent_, bitangent_, view_, stretched_;
  Real alpha_ = 1, spread_ = 0;
};

// The outline of the image: edges of half vectors, and triangles from each to the pole.
struct Image {
  const Lobe& lobe;
  Facet pole;
  Vec factor{0, 0, 0};
  Two weight{0, 0};
  Real light = 0;

  void piece(const Vec& from, const Vec& to) {
    const Facet a = lobe.ofLight(unit(from)), b = lobe.ofLight(unit(to));
    factor = sum(factor, arc(a.normal, b.normal));
    const Facet middle = lobe.ofNormal(unit(sum(sum(a.normal, b.normal), pole.normal)));
    const Real area = std::abs(dot(cross(sum(b.normal, a.normal, -1), sum(pole.normal, a.normal, -1)), middle.normal));
    const Facet* corners[] = {&a, &b, &pole};
    weight = sum(weight, middle.weight, 9 * area * middle.cosine);
    light += 9 * area * middle.cosine;
    for (const Facet* corner : corners) {
      weight = sum(weight, corner->weight, area * corner->cosine);
      light += area * corner->cosine;
    }
  }

  // In three: where it passes closest to the mirrored view, and in the middle of the longer part.
  void edge(const Vec& from, const Vec& to, Real tie) {
    const Real size = length(from);
    if (size <= 0) return;
    const Vec start = unit(from), end = unit(to), d = times(1 / size, sum(to, from, -1));
    const Vec mirrored{-lobe.view()[0], 0, lobe.view()[2]};
    const Real ar = dot(start, mirrored), dr = dot(d, mirrored), ad = dot(start, d);
    const Real below = dr * ad - ar * dot(d, d);
    const Real t =
        std::abs(below) > 1.0e-5L * dot(d, d) ? std::min(std::max((ar * ad - dr) / below, 0.1L), 0.9L) : 0.5L;
    const Vec split = unit(sum(start, d, t));
    if (dot(start, split) < dot(split, end) + tie) {
      const Vec middle = unit(sum(start, split));
      piece(start, middle);
      piece(middle, split);
      piece(split, end);
    } else {
      const Vec middle = unit(sum(split, end));
      piece(start, split);
      piece(split, middle);
      piece(middle, end);
    }
  }
};

}  // namespace

Real heightOverLamp(const Lamp& lamp, const Vec& position) {
  const Vec along = sum(lamp.corners[1], lamp.corners[0], -1), up = sum(lamp.corners[2], lamp.corners[0], -1);
  const Vec n = cross(along, up);
  const Real least = 1.0e-5L * length(n) * (length(along) + length(up));
  return least > 0 ? dot(n, sum(position, lamp.corners[0], -1)) / least : 0;
}

Real formFactor(const Lamp& lamp, const Vec& position, const Vec& normal) {
  const std::vector<Vec> polygon = above(seenFrom(lamp, position), normal);
  Real share = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    share += dot(arc(polygon[i], polygon[(i + 1) % polygon.size()]), normal);
  }
  return std::min(std::abs(share) / kTurn, 1.0L);
}

std::array<Real, 2> imageShare(const Lamp& lamp, const Vec& position, const Vec& normal, const Vec& view,
                               Real roughness, Real tie) {
  const Lobe lobe(normal, view, roughness);
  std::vector<Vec> corners;
  Vec middle{0, 0, 0};
  for (const Vec& corner : seenFrom(lamp, position)) {
    corners.push_back(lobe.local(corner));
    middle = sum(middle, corners.back());
  }
  middle[2] = std::max<Real>(middle[2], 0);
  const std::vector<Vec> polygon = above(corners, {0, 0, 1});
  if (polygon.size() < 3) return {0, 0};
  Image image{lobe, lobe.ofLight(unit(middle))};
  for (std::size_t i = 0; i < polygon.size(); ++i) image.edge(polygon[i], polygon[(i + 1) % polygon.size()], tie);
  const Real along = dot(image.factor, lobe.stretched()), size = length(image.factor);
  if (size <= 1.0e-20L) return {0, 0};
  const Real share = std::min(2 * std::abs(along) / kTurn / (1 + lobe.stretched()[2]), 1.0L);
  Two weight = lobe.ofNormal(times((along < 0 ? -1 : 1) / size, image.factor)).weight;
  if (image.light > 1.0e-30L) {
    const Two mean{image.weight[0] / image.light, image.weight[1] / image.light};
    weight = {weight[0] + lobe.spread() * (mean[0] - weight[0]), weight[1] + lobe.spread() * (mean[1] - weight[1])};
  }
  return {share * weight[0], share * weight[1]};
}

}  // namespace boxprobe::stress::exact
