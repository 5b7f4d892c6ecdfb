#include "filters/math/cube/cube_map.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

// Integral over the rectangle from the face's centre to (s, t) of the solid angle of the cube's face.
double cornerArea(double s, double t) {
  return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0));
}

// A texel beyond an edge, found by folding the face's plane over the edge of the cube. Folding keeps lengths, so texel
// centres land on texel centres. Coordinates in texels; at most one is outside.
struct TexelPlace {
  int face, column, row;
};

TexelPlace fold(int face, int column, int row, int size) {
  const bool inside = column >= 0 && column < size && row >= 0 && row < size;
  if (inside) return {face, column, row};
  const float step = 2.0f / static_cast<float>(size);
  const float s = -1.0f + (static_cast<float>(column) + 0.5f) * step;
  const float t = -1.0f + (static_cast<float>(row) + 0.5f) * step;
  // The point on the edge, and how far beyond it the texel lies.
  const float beyond = std::max(std::abs(s), std::abs(t)) - 1.0f;
  const glm::vec3 edge = shading::cubeDirection(face, std::clamp(s, -1.0f, 1.0f), std::clamp(t, -1.0f, 1.0f));
  const glm::vec3 axis = shading::cubeDirection(face, 0.0f, 0.0f);
  const CubePoint point = cubePoint(edge - beyond * axis);
  const auto index = [&](float x) { return std::clamp(static_cast<int>(std::floor((x + 1.0f) / step)), 0, size - 1); };
  return {point.face, index(point.s), index(point.t)};
}

}  // namespace

CubePoint cubePoint(const glm::vec3& d) {
  const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const float largest = std::max({x, y, z});
  if (!(largest > 0.0f)) return {};
  if (x >= y && x >= z) {
    return d.x > 0.0f ? CubePoint{0, -d.z / x, -d.y / x} : CubePoint{1, d.z / x, -d.y / x};
  }
  if (y >= z) return d.y > 0.0f ? CubePoint{2, d.x / y, d.z / y} : CubePoint{3, d.x / y, -d.z / y};
  return d.z > 0.0f ? CubePoint{4, d.x / z, -d.y / z} : CubePoint{5, -d.x / z, -d.y / z};
}

double cubeSolidAngle(double s0, double t0, double s1, double t1) {
  return cornerArea(s1, t1) - cornerArea(s0, t1) - cornerArea(s1, t0) + cornerArea(s0, t0);
}

// At most two levels of at most four texels.
struct CubeMap::Taps {
  std::array<TexelShare, 8> texels;
  std::size_t count = 0;
};

CubeMap::CubeMap(int faceSize, int levels) : faceSize_(faceSize), levels_(static_cast<std::size_t>(levels)) {
  for (int level = 0; level < levels; ++level) {
    const auto size = static_cast<std::size_t>(levelSize(level));
    levels_[static_cast<std::size_t>(level)].resize(6 * size * size * 4);
  }
}

int CubeMap::levelSize(int level) const {
  return std::max(faceSize_ >> level, 1);
}

float* CubeMap::face(int level, int face) {
  const auto size = static_cast<std::size_t>(levelSize(level));
  return &levels_[static_cast<std::size_t>(level)][static_cast<std::size_t>(face) * size * size * 4];
}

const float* CubeMap::face(int level, int face) const {
  const auto size = static_cast<std::size_t>(levelSize(level));
  return &levels_[static_cast<std::size_t>(level)][static_cast<std::size_t>(face) * size * size * 4];
}

glm::vec4 CubeMap::texel(int level, int f, int column, int row) const {
  const float* p = face(level, f) + 4 * (static_cast<std::ptrdiff_t>(row) * levelSize(level) + column);
  return {p[0], p[1], p[2], p[3]};
}

void CubeMap::setTexel(int level, int f, int column, int row, const glm::vec4& value) {
  float* p = face(level, f) + 4 * (static_cast<std::ptrdiff_t>(row) * levelSize(level) + column);
  for (int c = 0; c < 4; ++c) p[c] = value[c];
}

void CubeMap::tap(const glm::vec3& direction, int level, float weight, Taps& taps) const {
  if (weight <= 0.0f) return;
  const int size = levelSize(level);
  const CubePoint point = cubePoint(direction);
  const float u = (0.5f * point.s + 0.5f) * static_cast<float>(size) - 0.5f;
  const float v = (0.5f * point.t + 0.5f) * static_cast<float>(size) - 0.5f;
  const float column = std::floor(u), row = std::floor(v);
  const float a = u - column, b = v - row;
  const float shares[4] = {(1.0f - a) * (1.0f - b), a * (1.0f - b), (1.0f - a) * b, a * b};
  const auto outside = [size](int i) { return i < 0 || i >= size; };
  const std::size_t first = taps.count;
  float missing = 0.0f;
  for (int i = 0; i < 4; ++i) {
    const int x = static_cast<int>(column) + (i & 1), y = static_cast<int>(row) + (i >> 1);
    if (outside(x) && outside(y)) {
      missing = shares[i];
      continue;
    }
    const TexelPlace place = fold(point.face, x, y, size);
    taps.texels[taps.count++] = {level, place.face, place.column, place.row, shares[i] * weight};
  }
  if (missing > 0.0f) {
    for (std::size_t i = first; i < taps.count; ++i) taps.texels[i].share += missing * weight / 3.0f;
  }
}

CubeMap::Taps CubeMap::taps(const glm::vec3& direction, float level) const {
  const float clamped = std::clamp(level, 0.0f, maxLevel());
  const int lower = std::min(static_cast<int>(clamped), levels() - 1);
  const float fraction = clamped - static_cast<float>(lower);
  Taps result;
  tap(direction, lower, 1.0f - fraction, result);
  if (fraction > 0.0f) tap(direction, lower + 1, fraction, result);
  return result;
}

// Adds the four texels around a point, weighted as tap() does, if all lie within the face; returns false at its rim.
bool CubeMap::addInside(const CubePoint& point, int level, float weight, glm::vec4& sum) const {
  const int size = levelSize(level);
  const float u = (0.5f * point.s + 0.5f) * static_cast<float>(size) - 0.5f;
  const float v = (0.5f * point.t + 0.5f) * static_cast<float>(size) - 0.5f;
  const float column = std::floor(u), row = std::floor(v);
  const int x = static_cast<int>(column), y = static_cast<int>(row);
  if (x < 0 || y < 0 || x + 1 >= size || y + 1 >= size) return false;
  const float a = u - column, b = v - row;
  const float shares[4] = {(1.0f - a) * (1.0f - b), a * (1.0f - b), (1.0f - a) * b, a * b};
  const float* texels = face(level, point.face) + 4 * (static_cast<std::ptrdiff_t>(y) * size + x);
  for (int i = 0; i < 4; ++i) {
    const float* p = texels + 4 * (static_cast<std::ptrdiff_t>(i >> 1) * size + (i & 1));
    sum += shares[i] * weight * glm::vec4(p[0], p[1], p[2], p[3]);
  }
  return true;
}

glm::vec4 CubeMap::fetch(const glm::vec3& direction, float level) const {
  if (empty()) return glm::vec4(0.0f);
  const float clamped = std::clamp(level, 0.0f, maxLevel());
  const int lower = std::min(static_cast<int>(clamped), levels() - 1);
  const float fraction = clamped - static_cast<float>(lower);
  const CubePoint point = cubePoint(direction);
  glm::vec4 inside(0.0f);
  const bool all = addInside(point, lower, 1.0f - fraction, inside) &&
                   (fraction <= 0.0f || addInside(point, lower + 1, fraction, inside));
  if (all) return inside;
  const Taps found = taps(direction, level);
  glm::vec4 sum(0.0f);
  for (std::size_t i = 0; i < found.count; ++i) {
    const TexelShare& t = found.texels[i];
    sum += t.share * texel(t.level, t.face, t.column, t.row);
  }
  return sum;
}

std::vector<TexelShare> CubeMap::footprint(const glm::vec3& direction, float level) const {
  if (empty()) return {};
  const Taps found = taps(direction, level);
  std::vector<TexelShare> result;
  for (std::size_t i = 0; i < found.count; ++i) {
    if (found.texels[i].share > 0.0f) result.push_back(found.texels[i]);
  }
  return result;
}

}  // namespace boxprobe
