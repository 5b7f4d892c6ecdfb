// Random points of study_room.h and their reflected light.
#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/technique/technique_table.h"
#include "filters/reference/study/study_room.h"

namespace boxprobe::study {

using glm::dvec3;
using glm::vec3;

// Heitz 2018, weighted by G2 / G1 and by Schlick's reflectance of each facet; weights are normalised, as in the split
// sum.
dvec3 reflectedMean(const BoxRoom& room, const PaddedCube& chain, const shading::ShadingPoint& point, int rays) {
  const double a = std::max(static_cast<double>(point.roughness * point.roughness), 1e-4);
  const dvec3 n(point.normal), v(point.view), p(point.position);
  const dvec3 up = std::abs(n.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 x = glm::normalize(glm::cross(up, n)), y = glm::cross(n, x);
  const dvec3 local(glm::dot(v, x), glm::dot(v, y), glm::dot(v, n));
  const dvec3 vh = glm::normalize(dvec3(a * local.x, a * local.y, local.z));
  const double flat = vh.x * vh.x + vh.y * vh.y;
  const dvec3 t1 = flat > 0 ? dvec3(-vh.y, vh.x, 0) / std::sqrt(flat) : dvec3(1, 0, 0), t2 = glm::cross(vh, t1);
  const auto mask = [a](double c) { return std::sqrt(a * a + (1.0 - a * a) * c * c); };
  const double maskView = mask(local.z);
  dvec3 sum(0.0);
  double weights = 0.0;
  for (int i = 0; i < rays; ++i) {
    const double u1 = (i + 0.5) / rays, u2 = std::fmod(0.5 + i * 0.6180339887498949, 1.0);
    const double r = std::sqrt(u1), phi = 2.0 * 3.14159265358979 * u2;
    const double d1 = r * std::cos(phi), s = 0.5 * (1.0 + vh.z);
    const double d2 = (1.0 - s) * std::sqrt(1.0 - d1 * d1) + s * r * std::sin(phi);
    const dvec3 nh = d1 * t1 + d2 * t2 + std::sqrt(std::max(0.0, 1.0 - d1 * d1 - d2 * d2)) * vh;
    const dvec3 h = glm::normalize(dvec3(a * nh.x, a * nh.y, std::max(0.0, nh.z)));
    const dvec3 l = 2.0 * glm::dot(local, h) * h - local;
    if (l.z <= 0.0) continue;
    const double facet = point.f0 + (1.0 - point.f0) * std::pow(1.0 - std::min(glm::dot(local, h), 1.0), 5.0);
    const double w = facet * l.z * (local.z + maskView) / (local.z * mask(l.z) + l.z * maskView);
    const dvec3 d = l.x * x + l.y * y + l.z * n;
    double t = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
      const double wall = d[axis] < 0.0 ? room.low[axis] : room.high[axis];
      if (d[axis] != 0.0) t = std::min(t, std::max((wall - p[axis]) / d[axis], 0.0));
    }
    sum += w * dvec3(chain.fetch(vec3(glm::clamp(p + t * d, room.low, room.high)), 0.0f));
    weights += w;
  }
  return sum / weights;
}

namespace {

dvec3 anyDirection(std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const double x = gauss(random), y = gauss(random);
  return glm::normalize(dvec3(x, y, gauss(random)));
}

// A direction along the floor towards a lamp of the room.
dvec3 towardsLamp(const BoxRoom& room, const dvec3& from, std::mt19937& random) {
  const RoomLamp& lamp = room.lamps[std::uniform_int_distribution<std::size_t>(0, room.lamps.size() - 1)(random)];
  const int axis = lamp.wall / 2;
  dvec3 to;
  to[axis] = lamp.wall % 2 == 1 ? room.high[axis] : room.low[axis];
  for (int i = 0; i < 2; ++i) {
    const int k = (axis + 1 + i) % 3;
    to[k] = room.low[k] + lamp.middle[i] * (room.high[k] - room.low[k]);
  }
  return glm::normalize(dvec3(to.x - from.x, 0.0, to.z - from.z) + 0.2 * dvec3(anyDirection(random).x, 0.0, 0.0));
}

shading::ShadingPoint randomPoint(const BoxRoom& room, float roughness, int index, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double sx = unit(random), sy = unit(random), sz = unit(random);
  dvec3 p = room.low + (0.08 + 0.84 * dvec3(sx, sy, sz)) * (room.high - room.low), n(0, 1, 0);
  const int kind = index % 8;
  if (kind == 3) {  // on a wall
    const int side = std::uniform_int_distribution<int>(0, 3)(random), axis = side < 2 ? 0 : 2;
    const bool high = side % 2 == 1;
    p[axis] = high ? room.high[axis] : room.low[axis];
    n = dvec3(0.0);
    n[axis] = high ? -1.0 : 1.0;
  } else if (kind == 4 || kind == 5) {  // an object in the room
    n = anyDirection(random);
  } else {
    p.y = room.low.y;
    if (kind == 6) n = glm::normalize(dvec3(0, 1, 0) + 0.25 * anyDirection(random));
  }
  const bool low = kind == 7;
  const double angle = (low ? 60.0 + 27.0 * unit(random) : 85.0 * unit(random)) / 57.2957795;
  dvec3 side = low ? -towardsLamp(room, p, random) : anyDirection(random);
  side = glm::normalize(side - glm::dot(side, n) * n);
  shading::ShadingPoint point{};
  point.position = vec3(p);
  point.normal = vec3(n);
  point.view = vec3(glm::normalize(std::cos(angle) * n + std::sin(angle) * side));
  point.reflection = glm::reflect(-point.view, point.normal);
  point.roughness = roughness;
  point.pixel = glm::ivec2(index % 64, index / 64);
  return point;
}

}  // namespace

RoomPoints randomPoints(unsigned seed, int rooms, int pointsEach, int faceSize, int rays,
                        const std::function<bool(int)>& goOn, float f0) {
  constexpr float kMiddles[kRoughnesses] = {0.07f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f};
  std::mt19937 random(seed);
  RoomPoints result;
  for (int i = 0; i < rooms; ++i) {
    if (goOn && !goOn(i)) break;
    const BoxRoom room = randomRoom(1000 * seed + static_cast<unsigned>(i), i % 4 == 3);
    result.chains.push_back(std::make_unique<PaddedCube>(prefilteredRoom(room, faceSize)));
    RoomPoint p{};
    p.chain = result.chains.back().get();
    p.probe.boxMin = vec3(room.low);
    p.probe.boxMax = vec3(room.high);
    p.probe.maxLevel = p.chain->maxLevel();
    p.probe.projection = parseTechnique("box")->projection;
    p.probe.parameters = standardParameters();
    const std::size_t first = result.points.size();
    for (p.roughness = 0; p.roughness < kRoughnesses; ++p.roughness) {
      for (int k = 0; k < pointsEach; ++k) {
        const float near = std::uniform_real_distribution<float>(-0.05f, 0.05f)(random);
        p.point = randomPoint(room, glm::clamp(kMiddles[p.roughness] + near, 0.05f, 1.0f), k, random);
        p.point.f0 = f0;
        const float nv = glm::dot(p.point.normal, p.point.view);
        p.angle = nv > 0.7f ? 0 : nv > 0.35f ? 1 : 2;
        result.points.push_back(p);
      }
    }
    tbb::parallel_for(first, result.points.size(), [&](std::size_t k) {
      RoomPoint& to = result.points[k];
      to.truth = reflectedMean(room, *to.chain, to.point, rays);
    });
  }
  return result;
}

}  // namespace boxprobe::study
