// First draws an ordinary input: a room with the capture origin and the point inside, and a ray that leaves the
// surface. Then a class changes what it is about. All values are drawn in double and rounded once.
#include "filters/stress/stress_classes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace boxprobe::stress {

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0, 0.0, 1.0);
}

/// Sets R as given, N somewhere in its hemisphere, and V to the mirrored R.
void aim(StressInput& in, StressRandom& random, const glm::dvec3& r) {
  glm::dvec3 n = random.direction();
  if (glm::dot(n, r) < 0.0) n = -n;
  n = unit(n + 0.02 * r);
  in.reflection = glm::vec3(r);
  in.normal = glm::vec3(n);
  in.view = glm::vec3(unit(2.0 * glm::dot(n, r) * n - r));
}

/// R from N and V, by the program's own function.
void reflect(StressInput& in) {
  in.reflection = shading::reflectedView(in.normal, in.view);
}

glm::dvec3 within(const StressInput& in, StressRandom& random) {
  const glm::dvec3 low(in.boxMinWorld), high(in.boxMaxWorld);
  return {random.between(low.x, high.x), random.between(low.y, high.y), random.between(low.z, high.z)};
}

/// A box of these sides around the capture origin, the point inside it.
void setBox(StressInput& in, StressRandom& random, const glm::dvec3& sides) {
  for (int i = 0; i < 3; ++i) {
    const double share = random.between(0.02, 0.98);
    in.boxMinWorld[i] = static_cast<float>(-share * sides[i]);
    in.boxMaxWorld[i] = static_cast<float>((1.0 - share) * sides[i]);
  }
  in.positionWorld = glm::clamp(glm::vec3(within(in, random)), in.boxMinWorld, in.boxMaxWorld);
}

double side(const StressInput& in) {
  const glm::vec3 size = in.boxMaxWorld - in.boxMinWorld;
  return static_cast<double>(std::max({size.x, size.y, size.z}));
}

StressInput ordinary(StressRandom& random) {
  StressInput in;
  setBox(in, random, {random.logBetween(0.5, 30.0), random.logBetween(0.5, 30.0), random.logBetween(0.5, 30.0)});
  aim(in, random, random.direction());
  in.roughness = static_cast<float>(random.chance(0.1) ? random.below(2) : random.unit());
  in.maxLevel = static_cast<float>(random.chance(0.1) ? random.below(3) : 4 + random.below(7));
  in.blendDistance = static_cast<float>(side(in) * random.logBetween(0.01, 0.5));
  const glm::vec3 size = in.boxMaxWorld - in.boxMinWorld;
  constexpr double kBevels[] = {0.01, 0.1, 0.5, 1.0};
  in.bevel = static_cast<float>(0.5 * std::min({size.x, size.y, size.z}) *
                                (random.chance(0.5) ? random.unit() : kBevels[random.below(4)]));
  in.pixel = {random.below(4096), random.below(4096)};
  in.frame = random.below(64);
  return in;
}

/// Moves `count` coordinates of the point onto faces; the chosen axes come first in the result.
glm::ivec3 ontoFaces(StressInput& in, StressRandom& random, int count) {
  const int first = random.below(3), turn = random.chance(0.5) ? 1 : 2;
  const glm::ivec3 axes(first, (first + turn) % 3, (first + 2 * turn) % 3);
  for (int i = 0; i < count; ++i) {
    in.positionWorld[axes[i]] = random.chance(0.5) ? in.boxMinWorld[axes[i]] : in.boxMaxWorld[axes[i]];
  }
  return axes;
}

void noComponent(StressInput& in, StressRandom& random, int axis) {
  glm::dvec3 r = random.direction();
  r[axis] = 0.0;
  r = unit(r);
  r[axis] = random.sign() * 0.0;
  aim(in, random, r);
}

void zeroComponents(StressInput& in, StressRandom& random) {
  noComponent(in, random, random.below(3));
}
void axisParallel(StressInput& in, StressRandom& random) {
  glm::dvec3 r(0.0);
  for (int i = 0; i < 3; ++i) r[i] = random.sign() * 0.0;
  r[random.below(3)] = random.sign();
  aim(in, random, r);
  if (random.chance(0.5)) ontoFaces(in, random, 1 + random.below(3));
}
void onFace(StressInput& in, StressRandom& random) {
  ontoFaces(in, random, 1);
}
void onEdge(StressInput& in, StressRandom& random) {
  ontoFaces(in, random, 2);
}
void onCorner(StressInput& in, StressRandom& random) {
  ontoFaces(in, random, 3);
}
void sliding(StressInput& in, StressRandom& random) {
  const glm::ivec3 axes = ontoFaces(in, random, 1 + random.below(2));
  noComponent(in, random, axes.x);
}
void nextTo(StressInput& in, StressRandom& random, bool outside) {
  const int count = 1 + random.below(3);
  const glm::ivec3 axes = ontoFaces(in, random, count);
  for (int i = 0; i < count; ++i) {
    float& p = in.positionWorld[axes[i]];
    const bool low = p == in.boxMinWorld[axes[i]];
    p = std::nextafter(p, low == outside ? -kInf : kInf);
  }
  if (random.chance(0.3)) noComponent(in, random, axes.x);
}
void ulpInside(StressInput& in, StressRandom& random) {
  nextTo(in, random, false);
}
void ulpOutside(StressInput& in, StressRandom& random) {
  nextTo(in, random, true);
}
/// Outside by a fraction of the box, along one to three axes.
void outsideBy(StressInput& in, StressRandom& random, double least, double most) {
  const int count = 1 + random.below(3);
  const double size = side(in);
  const glm::ivec3 axes = ontoFaces(in, random, count);
  for (int i = 0; i < count; ++i) {
    float& p = in.positionWorld[axes[i]];
    const double away = size * random.logBetween(least, most);
    p = static_cast<float>(static_cast<double>(p) + (p == in.boxMinWorld[axes[i]] ? -away : away));
  }
}
void justOutside(StressInput& in, StressRandom& random) {
  outsideBy(in, random, 1e-7, 1e-3);
}
void outside(StressInput& in, StressRandom& random) {
  outsideBy(in, random, 1e-3, 2.0);
}
void farOutside(StressInput& in, StressRandom& random) {
  outsideBy(in, random, 2.0, 1e18);
  // Aims half of the rays at the box: otherwise nearly all would miss it.
  if (random.chance(0.5)) aim(in, random, unit(within(in, random) - glm::dvec3(in.positionWorld)));
}
void flat(StressInput& in, StressRandom& random) {
  const int axis = random.below(3);
  in.boxMaxWorld[axis] = in.boxMinWorld[axis] = 0.0f;
  if (random.chance(0.5))
    in.boxMaxWorld[axis] = in.boxMinWorld[axis] = static_cast<float>(side(in) * random.between(-0.5, 0.5));
  in.positionWorld[axis] = in.boxMinWorld[axis];
  in.bevel = 0.0f;
}
void point(StressInput& in, StressRandom& random) {
  if (random.chance(0.5)) in.boxMinWorld = glm::vec3(0.0f);
  in.boxMaxWorld = in.boxMinWorld;
  if (random.chance(0.5)) in.positionWorld = in.boxMinWorld;
  in.bevel = 0.0f;
}
void needle(StressInput& in, StressRandom& random) {
  glm::dvec3 sides(random.logBetween(1e-7, 1e-3), random.logBetween(1e-7, 1e-3), random.logBetween(1e-7, 1e-3));
  sides[random.below(3)] = 1.0;
  setBox(in, random, random.logBetween(1.0, 100.0) * sides);
}
/// A box of about this size, with everything else in proportion.
void scaled(StressInput& in, StressRandom& random, double least, double most) {
  const double s = random.logBetween(least, most);
  setBox(in, random, s * glm::dvec3(random.between(0.5, 2.0), random.between(0.5, 2.0), random.between(0.5, 2.0)));
  in.blendDistance = static_cast<float>(s * random.logBetween(0.01, 0.5));
  in.bevel = static_cast<float>(0.25 * s * random.unit());
}
void tiny(StressInput& in, StressRandom& random) {
  scaled(in, random, 1e-30, 1e-6);
}
void huge(StressInput& in, StressRandom& random) {
  scaled(in, random, 1e6, 1e18);
}
void denormal(StressInput& in, StressRandom& random) {
  scaled(in, random, 1e-44, 1e-38);
}
/// The same room elsewhere, rounded there, so that box, point and origin are exact floats.
void far(StressInput& in, StressRandom& random, double distance) {
  setBox(in, random, {random.between(4.0, 30.0), random.between(4.0, 30.0), random.between(4.0, 30.0)});
  in.originWorld = glm::vec3(random.direction() * distance * random.between(0.5, 1.5));
  for (glm::vec3* v : {&in.boxMinWorld, &in.boxMaxWorld, &in.positionWorld}) *v += in.originWorld;
}
void far5(StressInput& in, StressRandom& random) {
  far(in, random, 1e5);
}
void far6(StressInput& in, StressRandom& random) {
  far(in, random, 1e6);
}
void far7(StressInput& in, StressRandom& random) {
  far(in, random, 1e7);
}
/// Nearly parallel to one or two pairs of faces.
void grazing(StressInput& in, StressRandom& random) {
  glm::dvec3 r = unit(random.direction());
  const int axis = random.below(3);
  r[axis] = random.sign() * random.logBetween(1e-9, 1e-5);
  if (random.chance(0.5)) r[(axis + 1) % 3] = random.sign() * random.logBetween(1e-9, 1e-5);
  aim(in, random, unit(r));
  if (random.chance(0.5)) ontoFaces(in, random, 1 + random.below(3));
}
void towardsEdge(StressInput& in, StressRandom& random) {
  StressInput target = in;
  ontoFaces(target, random, 2 + random.below(2));
  aim(in, random, unit(glm::dvec3(target.positionWorld) - glm::dvec3(in.positionWorld)));
}
/// N.V from -1 to 1, mostly close to 0.
void viewAt(StressInput& in, StressRandom& random, double facing) {
  const glm::dvec3 n = random.direction();
  const glm::dvec3 t = unit(glm::cross(n, random.direction()));
  in.normal = glm::vec3(n);
  in.view = glm::vec3(facing * n + std::sqrt(std::max(1.0 - facing * facing, 0.0)) * t);
  reflect(in);
}
void grazingView(StressInput& in, StressRandom& random) {
  viewAt(in, random, random.chance(0.1) ? 0.0 : random.logBetween(1e-9, 1e-2));
}
void fromBehind(StressInput& in, StressRandom& random) {
  viewAt(in, random, random.chance(0.5) ? -random.unit() : -random.logBetween(1e-9, 1e-2));
}
void viewAlongNormal(StressInput& in, StressRandom& random) {
  const glm::dvec3 n = random.chance(0.3) ? glm::dvec3(0.0, 0.0, random.sign()) : random.direction();
  in.normal = glm::vec3(n);
  in.view = glm::vec3(unit(n + random.logBetween(1e-12, 1e-4) * random.direction()));
  if (random.chance(0.3)) in.view = in.normal;
  reflect(in);
}
void roughness0(StressInput& in, StressRandom&) {
  in.roughness = 0.0f;
}
void roughness1(StressInput& in, StressRandom&) {
  in.roughness = 1.0f;
}
void roughnessSmall(StressInput& in, StressRandom& random) {
  in.roughness = static_cast<float>(random.logBetween(1e-25, 0.05));
}
void roughnessOutside(StressInput& in, StressRandom& random) {
  in.roughness =
      static_cast<float>(random.chance(0.5) ? -random.logBetween(1e-10, 1e38) : random.logBetween(1.0000001, 1e38));
}
void originOutside(StressInput& in, StressRandom& random) {
  const double size = side(in);
  glm::vec3 move(0.0f);
  const int count = 1 + random.below(3);
  for (int i = 0; i < count; ++i) {
    const int axis = random.below(3);
    const double away = size * random.logBetween(1e-6, 2.0);
    move[axis] = static_cast<float>(random.chance(0.5) ? away - static_cast<double>(in.boxMinWorld[axis])
                                                       : -away - static_cast<double>(in.boxMaxWorld[axis]));
  }
  for (glm::vec3* v : {&in.boxMinWorld, &in.boxMaxWorld, &in.positionWorld}) *v += move;
}
void originOnWall(StressInput& in, StressRandom& random) {
  const int count = 1 + random.below(3), first = random.below(3);
  for (int i = 0; i < count; ++i) {
    const int axis = (first + i) % 3;
    const float move = random.chance(0.5) ? in.boxMinWorld[axis] : in.boxMaxWorld[axis];
    in.boxMinWorld[axis] -= move;
    in.boxMaxWorld[axis] -= move;
    in.positionWorld[axis] = glm::clamp(in.positionWorld[axis] - move, in.boxMinWorld[axis], in.boxMaxWorld[axis]);
    if (random.chance(0.5)) in.positionWorld[axis] = 0.0f;
  }
  if (random.chance(0.2)) in.positionWorld = glm::vec3(0.0f);
}
void atOrigin(StressInput& in, StressRandom& random) {
  const double near = random.chance(0.3) ? 0.0 : side(in) * random.logBetween(1e-12, 1e-4);
  in.positionWorld = glm::vec3(near * random.direction());
}
void rotated(StressInput& in, StressRandom& random) {
  in.turn = glm::vec3(random.direction() * random.between(0.0, 3.14));
  // Editors often make quarter turns, which leave components that are nearly, but not exactly, 0.
  if (random.chance(0.3)) {
    in.turn = glm::vec3(0.0f);
    in.turn[random.below(3)] = static_cast<float>(random.sign() * 1.5707963267948966);
    noComponent(in, random, random.below(3));
  }
  const glm::dmat3 turned(worldFromProbe(in.turn));
  for (glm::vec3* v : {&in.positionWorld, &in.normal, &in.view, &in.reflection})
    *v = glm::vec3(turned * glm::dvec3(*v));
}
void blendZero(StressInput& in, StressRandom& random) {
  in.blendDistance = 0.0f;
  if (random.chance(0.5)) ontoFaces(in, random, 1 + random.below(3));
}
void blendLarge(StressInput& in, StressRandom& random) {
  in.blendDistance = static_cast<float>(side(in) * random.logBetween(1.0, 1e12));
}
void parameterEnds(StressInput& in, StressRandom& random) {
  for (const ParameterRow& row : parameterRows()) {
    const bool high = random.chance(0.5);
    if (row.number != nullptr && row.kind == ParameterKind::Number) {
      in.parameters.*row.number = static_cast<float>(high ? row.max : row.min);
    }
  }
}
void noLength(StressInput& in, StressRandom& random) {
  const int which = 1 + random.below(7);
  const float size = random.chance(0.5) ? 0.0f : static_cast<float>(random.logBetween(1e-45, 1e-12));
  if ((which & 1) != 0) in.normal *= size;
  if ((which & 2) != 0) in.view *= size;
  if ((which & 4) != 0) in.reflection *= size;
}
void notFinite(StressInput& in, StressRandom& random) {
  const auto bad = [&] {
    const int kind = random.below(3);
    return kind == 0 ? kNaN : (kind == 1 ? kInf : -kInf);
  };
  const int which = 1 + random.below(31);
  if ((which & 1) != 0) in.positionWorld[random.below(3)] = bad();
  if ((which & 2) != 0) in.normal[random.below(3)] = bad();
  if ((which & 4) != 0) in.view[random.below(3)] = bad();
  if ((which & 8) != 0) in.reflection[random.below(3)] = bad();
  if ((which & 16) != 0) in.roughness = bad();
}

void drawParameter(StressInput& in, StressRandom& random, const ParameterRow& row) {
  if (row.choice != nullptr) {
    const int count = row.kind == ParameterKind::Switch ? 2 : std::max(1, static_cast<int>(row.choices.size()));
    in.parameters.*row.choice = random.below(count);
  } else if (row.number != nullptr && row.kind == ParameterKind::WholeNumber) {
    // Mostly few of what costs time, occasionally the maximum.
    const double u = random.unit();
    in.parameters.*row.number = static_cast<float>(std::floor(row.min * std::pow(row.max / row.min, u * u * u)));
  } else if (row.number != nullptr) {
    const double spread = random.unit();
    in.parameters.*row.number =
        static_cast<float>(random.chance(0.3) ? row.standard : row.min + spread * spread * (row.max - row.min));
  }
}

}  // namespace

const std::vector<StressClass>& stressClasses() {
  static const std::vector<StressClass> classes = {
      {"inside", "an ordinary room, the point and the capture origin inside", [](StressInput&, StressRandom&) {}},
      {"zero-component", "a component of the ray is 0 or -0", zeroComponents},
      {"axis-parallel", "two components of the ray are 0, half of them from faces", axisParallel},
      {"on-face", "the point lies in a face", onFace},
      {"on-edge", "the point lies on an edge", onEdge},
      {"on-corner", "the point lies in a corner", onCorner},
      {"sliding", "the point lies in a face and the ray runs along it", sliding, Held::Sliding},
      {"ulp-inside", "one float inside a face, edge or corner", ulpInside},
      {"ulp-outside", "one float outside a face, edge or corner", ulpOutside},
      {"just-outside", "outside by 1e-7 to 1e-3 of the box", justOutside},
      {"outside", "outside by up to two box sizes", outside},
      {"far-outside", "outside by 2 to 1e18 box sizes; errors in units of that distance", farOutside, Held::ByReach},
      {"flat", "the box has no extent along one axis", flat},
      {"point", "the box is a point", point, Held::ByReach},
      {"needle", "two sides 1e-7 to 1e-3 of the third", needle},
      {"tiny", "a box of 1e-30 to 1e-6", tiny},
      {"huge", "a box of 1e6 to 1e18", huge},
      {"denormal", "a box of 1e-44 to 1e-38, below the normal floats", denormal, Held::Finite},
      {"far-1e5", "a room 1e5 from the world's origin", far5},
      {"far-1e6", "a room 1e6 from the world's origin", far6},
      {"far-1e7", "a room 1e7 from the world's origin", far7},
      {"grazing", "a component of the ray of 1e-9 to 1e-5", grazing},
      {"towards-edge", "the ray leads into an edge or a corner", towardsEdge},
      {"grazing-view", "N.V of 0 to 1e-2", grazingView},
      {"from-behind", "N.V below 0, as interpolated normals have it", fromBehind},
      {"view-along-normal", "V is N, or next to it", viewAlongNormal},
      {"roughness-0", "roughness 0", roughness0},
      {"roughness-1", "roughness 1", roughness1},
      {"roughness-small", "roughness 1e-25 to 0.05", roughnessSmall},
      {"roughness-outside", "roughness below 0 or above 1, to 1e38", roughnessOutside},
      {"origin-outside", "the capture origin lies outside the box, by up to two sizes", originOutside},
      {"origin-on-wall", "the capture origin lies in a face, an edge or a corner, often the point beside it",
       originOnWall},
      {"at-origin", "the point is the capture origin, or within 1e-4 of the box of it", atOrigin},
      {"rotated", "a turned box, quarter turns among them", rotated},
      {"blend-0", "blend distance 0", blendZero},
      {"blend-large", "blend distance larger than the box, to 1e12 times", blendLarge},
      {"parameter-ends", "parameters at the ends of their ranges", parameterEnds},
      {"no-length", "normal, view or ray without length, or next to none", noLength, Held::Finite},
      {"not-finite", "NaN or infinity in position, normal, view, ray, roughness", notFinite, Held::Finite},
  };
  return classes;
}

StressInput makeInput(const StressClass& c, std::string_view subject, std::uint64_t seed, std::uint64_t index,
                      const std::vector<const ParameterRow*>& parameters) {
  StressRandom mixed(seed ^ (idHash(c.id) + 0x632be59bd9b4e019ULL * idHash(subject)));
  StressRandom random(mixed.next() ^ (index * 0xd1342543de82ef95ULL));
  StressInput in = ordinary(random);
  for (const ParameterRow* row : parameters) drawParameter(in, random, *row);
  c.shape(in, random);
  return in;
}

}  // namespace boxprobe::stress
