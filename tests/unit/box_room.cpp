#include "tests/unit/box_room.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/cube_filter.h"

namespace boxprobe::test {

using glm::dvec3;
using glm::vec3;

namespace {

dvec3 roomRadiance(const BoxRoom& room, const dvec3& hit) {
  const dvec3 size = room.high - room.low, s = (hit - room.low) / size;
  int axis = 0;
  double nearest = 2.0;
  bool high = false;
  for (int i = 0; i < 3; ++i) {
    if (s[i] < nearest) nearest = s[i], axis = i, high = false;
    if (1.0 - s[i] < nearest) nearest = 1.0 - s[i], axis = i, high = true;
  }
  const double u = s[(axis + 1) % 3], v = s[(axis + 2) % 3];
  const int wall = 2 * axis + (high ? 1 : 0);
  const double period = room.checks;
  const bool odd = (static_cast<int>(u * period) + static_cast<int>(v * period)) % 2 != 0;
  dvec3 color = 0.15 + 0.5 * dvec3(wall % 3 == 0, wall % 3 == 1, wall % 3 == 2) * (odd ? 1.0 : 0.4);
  if (wall == 3) {  // the ceiling: lamps
    const double r = std::hypot(u - 0.3, v - 0.6);
    if (r < room.lampRadius) color = dvec3(room.lampRadiance);
  }
  if (wall == 0 && std::abs(u - 0.5) < 0.2 && std::abs(v - 0.5) < 0.2) color = dvec3(2.0, 2.5, 4.0);  // a window
  return color;
}

dvec3 exitOf(const BoxRoom& room, const dvec3& p, const dvec3& d) {
  double t = 1e30;
  for (int i = 0; i < 3; ++i) {
    if (d[i] != 0.0) t = std::min(t, std::max(((d[i] < 0.0 ? room.low[i] : room.high[i]) - p[i]) / d[i], 0.0));
  }
  return glm::clamp(p + t * d, room.low, room.high);
}

}  // namespace

CubeMap prefilteredRoom(const BoxRoom& room, int faceSize) {
  CubeMap capture(faceSize, 1);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        dvec3 sum(0.0);
        for (int i = 0; i < 16; ++i) {  // as an anti-aliased capture
          const float s = 2.0f * (static_cast<float>(column) + (static_cast<float>(i % 4) + 0.5f) / 4.0f) /
                              static_cast<float>(faceSize) -
                          1.0f;
          const float t = 2.0f * (static_cast<float>(row) + (static_cast<float>(i / 4) + 0.5f) / 4.0f) /
                              static_cast<float>(faceSize) -
                          1.0f;
          sum += roomRadiance(room, exitOf(room, dvec3(0.0), dvec3(shading::cubeDirection(face, s, t)))) / 16.0;
        }
        capture.setTexel(0, face, column, row, glm::vec4(vec3(sum), 1.0f));
      }
    }
  }
  return prefilterCube(capture, PrefilterSettings{});
}

// Heitz 2018, weighted by G2 / G1; the weights normalised, as the split sum has it.
dvec3 reflectedMean(const BoxRoom& room, const CubeMap& chain, const shading::ShadingPoint& point, int rays) {
  const double a = std::max(static_cast<double>(point.roughness * point.roughness), 1e-4);
  const dvec3 n(point.normal), v(point.view), p(point.position);
  const dvec3 up = std::abs(n.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 x = glm::normalize(glm::cross(up, n)), y = glm::cross(n, x);
  const dvec3 local(glm::dot(v, x), glm::dot(v, y), glm::dot(v, n));
  const dvec3 vh = glm::normalize(dvec3(a * local.x, a * local.y, local.z));
  const double flat = vh.x * vh.x + vh.y * vh.y;
  const dvec3 t1 = flat > 0 ? dvec3(-vh.y, vh.x, 0) / std::sqrt(flat) : dvec3(1, 0, 0), t2 = glm::cross(vh, t1);
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
    const auto lambda = [a](double c) { return std::sqrt(a * a + (1.0 - a * a) * c * c); };
    const double w = l.z * (local.z + lambda(local.z)) / (local.z * lambda(l.z) + l.z * lambda(local.z));
    sum += w * dvec3(chain.fetch(vec3(exitOf(room, p, l.x * x + l.y * y + l.z * n)), 0.0f));
    weights += w;
  }
  return sum / weights;
}

shading::ShadingPoint pointInRoom(const BoxRoom& room, float roughness, int index, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const dvec3 s(0.1 + 0.8 * unit(random), 0.1 + 0.8 * unit(random), 0.1 + 0.8 * unit(random));
  dvec3 p = room.low + s * (room.high - room.low), n(0, 1, 0);
  if (index % 4 < 2) {
    p.y = room.low.y;  // the floor
  } else if (index % 4 == 2) {
    p.z = room.low.z;  // a wall
    n = {0, 0, 1};
  } else {  // something inside the room
    n = glm::normalize(dvec3(unit(random) - 0.5, unit(random) - 0.2, unit(random) - 0.5));
  }
  const double angle = 85.0 / 57.29578 * unit(random), turn = 6.2831853 * unit(random);
  const dvec3 x = glm::normalize(glm::cross(std::abs(n.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n));
  const dvec3 v = std::cos(angle) * n + std::sin(angle) * (std::cos(turn) * x + std::sin(turn) * glm::cross(n, x));
  shading::ShadingPoint point;
  point.position = vec3(p);
  point.normal = vec3(n);
  point.view = vec3(v);
  point.reflection = glm::reflect(-point.view, point.normal);
  point.roughness = roughness;
  point.pixel = glm::ivec2(index % 64, index / 64);
  point.frame = 0;
  return point;
}

namespace {

double display(double x) {
  return std::pow(x / (1.0 + x), 1.0 / 2.2);
}

}  // namespace

void ErrorTally::add(const dvec3& value, const dvec3& truth) {
  for (int i = 0; i < 3; ++i) {
    squares += std::pow(display(value[i]) - display(truth[i]), 2.0);
    linearSquares += std::pow(value[i] - truth[i], 2.0);
    truthSquares += truth[i] * truth[i];
    light += value[i];
    truthLight += truth[i];
    ++count;
  }
}

double ErrorTally::rmse() const {
  return std::sqrt(squares / static_cast<double>(count));
}

double ErrorTally::relativeRmse() const {
  return std::sqrt(linearSquares / truthSquares);
}

}  // namespace boxprobe::test
