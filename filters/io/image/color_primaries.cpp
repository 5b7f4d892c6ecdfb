// Lindbloom, "RGB/XYZ Matrices" and "Chromatic Adaptation": columns are the primaries' XYZ, scaled to add up to white.
#include "filters/io/image/color_primaries.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

namespace {

constexpr double kLeastWhiteY = 1e-3, kLeastVolume = 1e-6;

glm::dvec3 whiteXyz(const glm::dvec2& xy) {
  return glm::dvec3(xy.x, xy.y, 1.0 - xy.x - xy.y) / xy.y;
}

/// Chromaticities without their scale: a primary of XYZ itself has y = 0.
glm::dmat3 chromaticityColumns(const ColorPrimaries& p) {
  const auto column = [](const glm::dvec2& xy) { return glm::dvec3(xy.x, xy.y, 1.0 - xy.x - xy.y); };
  return {column(p.red), column(p.green), column(p.blue)};
}

glm::dmat3 xyzFrom(const ColorPrimaries& p) {
  glm::dmat3 columns = chromaticityColumns(p);
  const glm::dvec3 scale = glm::inverse(columns) * whiteXyz(p.white);
  for (int i = 0; i < 3; ++i) columns[i] *= scale[i];
  return columns;
}

/// Takes XYZ under one white to XYZ under another (Bradford's cone responses, von Kries' scaling).
glm::dmat3 adaptation(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dmat3 cones(glm::dvec3(0.8951, -0.7502, 0.0389), glm::dvec3(0.2664, 1.7135, -0.0685),
                         glm::dvec3(-0.1614, 0.0367, 1.0296));
  const glm::dvec3 gain = (cones * to) / (cones * from);
  const glm::dmat3 scale(glm::dvec3(gain.x, 0, 0), glm::dvec3(0, gain.y, 0), glm::dvec3(0, 0, gain.z));
  return glm::inverse(cones) * scale * cones;
}

bool sameColor(const glm::dvec2& a, const glm::dvec2& b) {
  constexpr double kRounding = 2e-4;  // some writers give three or four digits
  return std::fabs(a.x - b.x) < kRounding && std::fabs(a.y - b.y) < kRounding;
}

bool allFinite(const glm::dmat3& m) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(m[i].x) || !std::isfinite(m[i].y) || !std::isfinite(m[i].z)) return false;
  }
  return true;
}

}  // namespace

ColorPrimaries acesPrimaries() {
  return {{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}};
}

std::optional<glm::dmat3> rec709From(const ColorPrimaries& from) {
  const ColorPrimaries to;
  for (const glm::dvec2& xy : {from.red, from.green, from.blue, from.white}) {
    if (!std::isfinite(xy.x) || !std::isfinite(xy.y)) return {};
  }
  if (sameColor(from.red, to.red) && sameColor(from.green, to.green) && sameColor(from.blue, to.blue) &&
      sameColor(from.white, to.white)) {
    return glm::dmat3(1.0);
  }
  if (from.white.y < kLeastWhiteY || std::fabs(glm::determinant(chromaticityColumns(from))) < kLeastVolume) return {};
  const glm::dmat3 result =
      glm::inverse(xyzFrom(to)) * adaptation(whiteXyz(from.white), whiteXyz(to.white)) * xyzFrom(from);
  if (!allFinite(result)) return {};
  return result;
}

glm::dmat3 rec709FromXyz() {
  return glm::inverse(xyzFrom(ColorPrimaries()));
}

}  // namespace boxprobe
