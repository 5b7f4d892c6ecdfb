// Diffuse light in 64 rooms made up by chance, as it is drawn from nine coefficients of the capture and as lamps drawn
// as shapes and a lattice give it, against rays: the rooms, their rays and the integrals are this file's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/cube/spherical_harmonics.h"
#include "filters/math/technique/technique_table.h"

namespace {

using namespace boxprobe;
using glm::dvec3;
using glm::vec3;

constexpr double kPi = 3.14159265358979323846;

struct PanelLamp {
  int wall = 0;
  dvec3 middle{0.0}, u{0.0}, v{0.0};  // half edges
  dvec3 inward{0.0};
  dvec3 radiance{0.0};
};

// A box about the capture origin. Each wall is two colours in cells, brighter towards one corner.
struct PatternRoom {
  dvec3 low, high;
  struct Wall {
    dvec3 light, dark;
    double cells[2];
    double slope[2];
    int pattern;  // checks, stripes, waves, plain
  } walls[6];
  std::vector<PanelLamp> lamps;

  struct Seen {
    dvec3 radiance{0.0};
    bool lamp = false;
  };

  // What a ray from within meets. Plain: the smallest of the three distances to the planes ahead.
  Seen along(const dvec3& from, const dvec3& d, bool withLamps) const {
    double nearest = 1e300;
    int axis = 0;
    for (int a = 0; a < 3; ++a) {
      if (std::abs(d[a]) < 1e-12) continue;
      const double t = ((d[a] > 0.0 ? high[a] : low[a]) - from[a]) / d[a];
      if (t < nearest) {
        nearest = t;
        axis = a;
      }
    }
    const int wall = 2 * axis + (d[axis] > 0.0 ? 1 : 0);
    const dvec3 p = from + std::max(nearest, 0.0) * d;
    for (const PanelLamp& lamp : lamps) {
      if (lamp.wall != wall) continue;
      const dvec3 off = p - lamp.middle;
      if (std::abs(glm::dot(off, lamp.u)) > glm::dot(lamp.u, lamp.u)) continue;
      if (std::abs(glm::dot(off, lamp.v)) > glm::dot(lamp.v, lamp.v)) continue;
      return {withLamps ? lamp.radiance : dvec3(0.0), true};
    }
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double x = (p[i] - low[i]) / (high[i] - low[i]), y = (p[j] - low[j]) / (high[j] - low[j]);
    const Wall& w = walls[wall];
    const int column = static_cast<int>(std::floor(x * w.cells[0])), row = static_cast<int>(std::floor(y * w.cells[1]));
    double mix = 0.0;
    if (w.pattern == 0) mix = (column + row) % 2 != 0 ? 1.0 : 0.0;
    if (w.pattern == 1) mix = column % 2 != 0 ? 1.0 : 0.0;
    if (w.pattern == 2) mix = 0.5 + 0.5 * std::sin(kPi * x * w.cells[0]) * std::cos(kPi * y * w.cells[1]);
    return {glm::mix(w.light, w.dark, mix) * (1.0 + w.slope[0] * (x - 0.5) + w.slope[1] * (y - 0.5)), false};
  }
};

PatternRoom makeRoom(unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  PatternRoom room;
  const dvec3 size(in(3.0, 12.0), in(2.3, 5.0), in(3.0, 12.0));
  room.low = -size * dvec3(in(0.25, 0.75), in(0.25, 0.75), in(0.25, 0.75));
  room.high = room.low + size;
  double flux = 0.0;
  for (int i = 0; i < 6; ++i) {
    PatternRoom::Wall& wall = room.walls[i];
    const double base = std::exp(in(std::log(0.03), 0.0));
    wall.light = base * dvec3(in(0.4, 1.0), in(0.4, 1.0), in(0.4, 1.0));
    wall.dark = wall.light * dvec3(in(0.0, 0.9), in(0.0, 0.9), in(0.0, 0.9));
    for (int k = 0; k < 2; ++k) {
      wall.cells[k] = 2.0 + below(6);
      wall.slope[k] = in(-0.8, 0.8);
    }
    wall.pattern = below(4);
    const int a = i / 2;
    flux += size[(a + 1) % 3] * size[(a + 2) % 3] * base * 0.5;
  }
  const int count = 1 + below(4);
  const double share = std::exp(in(std::log(0.4), std::log(2.5))) * flux / count;  // lamps' light over the walls'
  for (int k = 0; k < count; ++k) {
    constexpr int kWhere[] = {3, 3, 3, 0, 1, 4, 5};  // above all in the ceiling
    PanelLamp lamp;
    lamp.wall = kWhere[below(7)];
    const int axis = lamp.wall / 2, i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double half = 0.5 * std::exp(in(std::log(0.1), std::log(1.2))), other = half * in(0.4, 1.0);
    lamp.middle[axis] = lamp.wall % 2 != 0 ? room.high[axis] : room.low[axis];
    lamp.middle[i] = room.low[i] + half + in(0.05, 0.95) * (size[i] - 2.0 * half);
    lamp.middle[j] = room.low[j] + other + in(0.05, 0.95) * (size[j] - 2.0 * other);
    lamp.u[i] = half;
    lamp.v[j] = other;
    lamp.inward[axis] = lamp.wall % 2 != 0 ? -1.0 : 1.0;
    lamp.radiance = share / (4.0 * half * other) * dvec3(in(0.7, 1.0), in(0.7, 1.0), in(0.5, 1.0));
    room.lamps.push_back(lamp);
  }
  return room;
}

LampPolygon shapeOf(const PanelLamp& lamp) {
  LampPolygon polygon;
  polygon.count = 4;
  dvec3 u = lamp.u;
  if (glm::dot(glm::cross(lamp.u, lamp.v), lamp.inward) < 0.0) u = -u;
  polygon.corners[0] = vec3(lamp.middle - u - lamp.v);
  polygon.corners[1] = vec3(lamp.middle + u - lamp.v);
  polygon.corners[2] = vec3(lamp.middle + u + lamp.v);
  polygon.corners[3] = vec3(lamp.middle - u + lamp.v);
  return polygon;
}

// Two by two points of each texel, as captures have.
CubeMap captureOf(const PatternRoom& room, int faceSize, bool withLamps) {
  constexpr int kFine = 2;
  CubeMap capture(faceSize, 1);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        dvec3 sum(0.0);
        for (int i = 0; i < kFine * kFine; ++i) {
          const double s = 2.0 * (column + (i % kFine + 0.5) / kFine) / faceSize - 1.0;
          const double t = 2.0 * (row + (i / kFine + 0.5) / kFine) / faceSize - 1.0;
          const dvec3 d(shading::cubeDirection(face, static_cast<float>(s), static_cast<float>(t)));
          sum += room.along(dvec3(0.0), d, withLamps).radiance;
        }
        capture.setTexel(0, face, column, row, glm::vec4(vec3(sum / double(kFine * kFine)), 1.0f));
      }
    }
  }
  return capture;
}

// Irradiance over pi: of walls by rays of equal cosine, of lamps by points of their area.
dvec3 trueIrradiance(const PatternRoom& room, const dvec3& p, const dvec3& n) {
  const dvec3 t = glm::normalize(glm::cross(std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n)),
              b = glm::cross(n, t);
  constexpr int kRays = 4096;
  dvec3 walls(0.0);
  for (int i = 0; i < kRays; ++i) {
    unsigned bits = static_cast<unsigned>(i);  // Hammersley's points
    double radical = 0.0;
    for (double digit = 0.5; bits != 0; bits >>= 1, digit *= 0.5) radical += (bits & 1u) != 0 ? digit : 0.0;
    const double r = std::sqrt((i + 0.5) / kRays), phi = 2.0 * kPi * radical;
    const dvec3 d = r * std::cos(phi) * t + r * std::sin(phi) * b + std::sqrt(1.0 - r * r) * n;
    walls += room.along(p, d, false).radiance;
  }
  dvec3 sum = walls / double(kRays);
  for (const PanelLamp& lamp : room.lamps) {
    constexpr int kPoints = 40;
    double share = 0.0;
    for (int i = 0; i < kPoints * kPoints; ++i) {
      const dvec3 to = lamp.middle + ((i % kPoints + 0.5) / (kPoints / 2) - 1.0) * lamp.u +
                       ((i / kPoints + 0.5) / (kPoints / 2) - 1.0) * lamp.v - p;
      const double d2 = glm::dot(to, to);
      share += std::max(glm::dot(to, n), 0.0) * std::max(-glm::dot(to, lamp.inward), 0.0) / (d2 * d2);
    }
    const double area = 4.0 * glm::length(lamp.u) * glm::length(lamp.v);
    sum += lamp.radiance * (share * area / (kPi * kPoints * kPoints));
  }
  return sum;
}

// Nine coefficients of the capture, lamps in it.
class FromOrigin {
 public:
  explicit FromOrigin(const CubeMap& capture) {
    const CubeMap means = plainMeans(capture);
    const int level = means.levels() - 5, size = means.levelSize(level);  // 16² faces
    std::array<std::vector<float>, 6> faces;
    for (int face = 0; face < 6; ++face) {
      const float* texels = means.face(level, face);
      faces[static_cast<std::size_t>(face)].assign(texels, texels + 4 * size * size);
    }
    c_ = irradianceCoefficients(faces, size);
  }
  dvec3 at(const vec3& n) const {
    return dvec3(shading::shIrradiance(n, c_[0], c_[1], c_[2], c_[3], c_[4], c_[5], c_[6], c_[7], c_[8]));
  }

 private:
  ShCoefficients c_{};
};

class LampsAndLattice {
 public:
  LampsAndLattice(const PatternRoom& room, const CubeMap& lampFree, float spacing = 1.0f) : room_(room) {
    shading::ProbeShape probe{};
    probe.boxMin = vec3(room.low);
    probe.boxMax = vec3(room.high);
    probe.projection = parseTechnique("box").value().projection;
    probe.parameters = standardParameters();
    LatticeSettings settings;
    settings.spacing = spacing;
    lattice_ = makeDiffuseLattice(plainMeans(lampFree), probe, glm::mat3(1.0f), glm::mat3(1.0f), settings);
    for (const PanelLamp& lamp : room.lamps) polygons_.push_back(shapeOf(lamp));
  }
  dvec3 at(const vec3& p, const vec3& n, bool lamps = true) const {
    dvec3 sum(shading::latticeIrradiance(lattice_.shape(), p, n, n));
    for (std::size_t i = 0; lamps && i < polygons_.size(); ++i) {
      sum += room_.lamps[i].radiance * static_cast<double>(shading::lampDiffuse(&polygons_[i], p, n));
    }
    return sum;
  }

 private:
  const PatternRoom& room_;
  DiffuseLattice lattice_;
  std::vector<LampPolygon> polygons_;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

TEST(DiffuseRooms, LampsAsShapesAndALatticeAreNearTheTruth) {
  constexpr unsigned kRooms = 64;
  constexpr int kPoints = 120;
  struct Scheme {
    const char* name;
    std::vector<double> rmse, ratio, behind;
  } schemes[] = {{"nine coefficients", {}, {}, {}},
                 {"lattice, lamps left in", {}, {}, {}},
                 {"lamps as shapes, lattice of 2 m", {}, {}, {}},
                 {"lamps as shapes, lattice of 1 m", {}, {}, {}}};
  constexpr std::size_t kSchemes = std::size(schemes);
  for (unsigned seed = 0; seed < kRooms; ++seed) {
    const PatternRoom room = makeRoom(4000 + 17 * seed);
    const CubeMap whole = captureOf(room, 128, true), lampFree = captureOf(room, 128, false);
    const FromOrigin coefficients(whole);
    const LampsAndLattice lampsIn(room, whole), wide(room, lampFree, 2.0f), close(room, lampFree);
    std::mt19937 random(seed);
    const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    std::array<double, kSchemes> off{}, light{}, behindLight{};
    double square = 0.0, trueLight = 0.0, behindTrue = 0.0;
    for (int i = 0; i < kPoints;) {
      dvec3 p, n(0.0);
      for (int a = 0; a < 3; ++a) p[a] = in(room.low[a] + 0.02, room.high[a] - 0.02);
      bool behind = false;
      if (i % 3 != 0) {  // on a wall, a floor
        const int axis = (i / 3) % 3, side = (i % 3) - 1;
        p[axis] = side != 0 ? room.high[axis] - 0.002 : room.low[axis] + 0.002;
        n[axis] = side != 0 ? -1.0 : 1.0;
      } else {  // of something in the room: any way round, or with its back to a lamp
        n = glm::normalize(dvec3(in(-1, 1), in(-1, 1), in(-1, 1)) + 1e-3);
        behind = i % 2 == 0;
        if (behind) n = glm::normalize(p - room.lamps[0].middle);
      }
      const bool near = std::any_of(room.lamps.begin(), room.lamps.end(), [&](const PanelLamp& lamp) {
        return glm::length(lamp.middle - p) < glm::length(lamp.u) + glm::length(lamp.v) + 0.1;
      });
      if (near) continue;  // for the truth's sake
      ++i;
      const dvec3 truth = trueIrradiance(room, p, n);
      const dvec3 found[kSchemes] = {coefficients.at(vec3(n)), lampsIn.at(vec3(p), vec3(n), false),
                                     wide.at(vec3(p), vec3(n)), close.at(vec3(p), vec3(n))};
      square += glm::dot(truth, truth);
      trueLight += truth.x + truth.y + truth.z;
      if (behind) behindTrue += truth.x + truth.y + truth.z;
      for (std::size_t k = 0; k < kSchemes; ++k) {
        off[k] += glm::dot(found[k] - truth, found[k] - truth);
        light[k] += found[k].x + found[k].y + found[k].z;
        if (behind) behindLight[k] += found[k].x + found[k].y + found[k].z;
      }
    }
    for (std::size_t k = 0; k < kSchemes; ++k) {
      schemes[k].rmse.push_back(std::sqrt(off[k] / square));
      schemes[k].ratio.push_back(light[k] / trueLight);
      schemes[k].behind.push_back(behindLight[k] / behindTrue);
    }
  }
  std::printf(
      "| diffuse light of | relative RMSE, median | 90 %% | worst | light over the truth's | behind a lamp |\n"
      "|---|---|---|---|---|---|\n");
  for (const Scheme& s : schemes) {
    std::printf("| %s | %.3f | %.3f | %.3f | %.2f (%.2f to %.2f) | %.2f to %.2f |\n", s.name, quantile(s.rmse, 0.5),
                quantile(s.rmse, 0.9), quantile(s.rmse, 1.0), quantile(s.ratio, 0.5), quantile(s.ratio, 0.05),
                quantile(s.ratio, 0.95), quantile(s.behind, 0.05), quantile(s.behind, 0.95));
  }
  const Scheme& best = schemes[kSchemes - 1];
  EXPECT_LE(quantile(best.rmse, 0.5), 0.03);
  EXPECT_LE(quantile(best.rmse, 0.9), 0.08);
  EXPECT_NEAR(quantile(best.ratio, 0.5), 1.0, 0.01);
  EXPECT_GT(quantile(schemes[0].rmse, 0.5), 0.3);  // what is judged is hard enough to tell
}

// Walls of 0.1 and a lamp of 300, seen from a point of the room: a Lambert surface turned away from the lamp by
// degrees.
TEST(DiffuseRooms, ASurfaceMayTurnAwayFromABrightLamp) {
  PatternRoom room;
  room.low = {-2.3, -1.2, -1.7};
  room.high = {2.6, 1.5, 3.1};
  for (PatternRoom::Wall& wall : room.walls) wall = {dvec3(0.1), dvec3(0.1), {1.0, 1.0}, {0.0, 0.0}, 3};
  PanelLamp lamp;
  lamp.wall = 3;
  lamp.middle = {0.9, 1.5, 0.4};
  lamp.u = {0.15, 0.0, 0.0};
  lamp.v = {0.0, 0.0, 0.11};
  lamp.inward = {0.0, -1.0, 0.0};
  lamp.radiance = dvec3(300.0);
  room.lamps.push_back(lamp);
  const FromOrigin coefficients(captureOf(room, 128, true));
  const LampsAndLattice drawn(room, captureOf(room, 128, false));
  const dvec3 p(-0.8, -0.7, 1.3), to = glm::normalize(lamp.middle - p);
  const dvec3 aside = glm::normalize(glm::cross(to, dvec3(0.3, 0.2, 0.9)));
  std::printf("| degrees from the lamp | truth | nine coefficients | lamps as shapes, lattice |\n|---|---|---|---|\n");
  double worstBefore = 0.0;
  for (const double degrees : {0.0, 30.0, 60.0, 85.0, 90.0, 110.0, 130.0, 180.0}) {
    const double a = degrees * kPi / 180.0;
    const dvec3 n = std::cos(a) * to + std::sin(a) * aside;
    const double truth = trueIrradiance(room, p, n).x, found = drawn.at(vec3(p), vec3(n)).x;
    const double before = coefficients.at(vec3(n)).x;
    std::printf("| %g | %.4f | %.4f | %.4f |\n", degrees, truth, before, found);
    EXPECT_NEAR(found / truth, 1.0, 0.05) << degrees;
    worstBefore = std::max(worstBefore, std::abs(before / truth - 1.0));
  }
  EXPECT_GT(worstBefore, 0.5);
}

}  // namespace
