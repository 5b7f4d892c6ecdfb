// See ground_shadow.h.
#include "filters/core/geometry/ground_shadow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kGroundTexels = 96;  // along the longer side
constexpr int kGroundRays = 96;    // from a texel

/// Cosine-weighted about +y, along a spiral that is turned by `turn` from texel to texel.
glm::dvec3 skyward(int ray, double turn) {
  const double u = (ray + 0.5) / kGroundRays, r = std::sqrt(u), angle = 2.399963229728653 * ray + turn;
  return {r * std::cos(angle), std::sqrt(1.0 - u), r * std::sin(angle)};
}

/// Binomial, along both axes; edges are lit.
void blur(GroundShadow& shadow) {
  const auto along = [&](int dx, int dz) {
    std::vector<float> result(shadow.light.size());
    const auto at = [&](int x, int z) {
      const bool inside = x >= 0 && z >= 0 && x < shadow.columns && z < shadow.rows;
      return inside ? shadow.light[static_cast<std::size_t>(z * shadow.columns + x)] : 1.0f;
    };
    for (int z = 0; z < shadow.rows; ++z) {
      for (int x = 0; x < shadow.columns; ++x) {
        result[static_cast<std::size_t>(z * shadow.columns + x)] =
            0.25f * at(x - dx, z - dz) + 0.5f * at(x, z) + 0.25f * at(x + dx, z + dz);
      }
    }
    shadow.light = std::move(result);
  };
  along(1, 0);
  along(0, 1);
}

/// Full towards the edges, so that the plane itself is not seen.
double fade(double place, double low, double high) {
  const double edge = std::min(place - low, high - place) / (0.25 * (high - low));
  const double s = std::clamp(edge, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

GroundShadow tracedGroundShadow(const SightLines& lines, const Box& bounds, const std::function<bool()>& stop) {
  const glm::dvec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z});
  if (lines.empty() || !(longest > 0.0) || !std::isfinite(longest)) return {};
  GroundShadow shadow;
  // A little below, so that what lies flat on it is seen to lie on it.
  shadow.height = bounds.min.y - 2.0e-3 * longest;
  shadow.low = glm::dvec2(bounds.min.x, bounds.min.z) - longest;
  shadow.high = glm::dvec2(bounds.max.x, bounds.max.z) + longest;
  const glm::dvec2 plane = shadow.high - shadow.low;
  const double texel = std::max(plane.x, plane.y) / kGroundTexels;
  shadow.columns = std::max(1, static_cast<int>(std::lround(plane.x / texel)));
  shadow.rows = std::max(1, static_cast<int>(std::lround(plane.y / texel)));
  shadow.light.assign(static_cast<std::size_t>(shadow.columns) * static_cast<std::size_t>(shadow.rows), 1.0f);
  tbb::parallel_for(0, shadow.rows, [&](int row) {
    if (stop && stop()) return;
    for (int column = 0; column < shadow.columns; ++column) {
      const double x = shadow.low.x + (column + 0.5) / shadow.columns * plane.x;
      const double z = shadow.low.y + (row + 0.5) / shadow.rows * plane.y;
      const double turn = 2.0 * kPi * std::fmod(0.7548776662466927 * column + 0.5698402909980532 * row, 1.0);
      int open = 0;
      for (int ray = 0; ray < kGroundRays; ++ray) {
        const glm::dvec3 direction = skyward(ray, turn);
        const glm::dvec3 from(x, shadow.height, z);
        open += lines.blocked(from, from + 4.0 * longest * direction, true) ? 0 : 1;
      }
      const double light = static_cast<double>(open) / kGroundRays;
      const double share = fade(x, shadow.low.x, shadow.high.x) * fade(z, shadow.low.y, shadow.high.y);
      shadow.light[static_cast<std::size_t>(row * shadow.columns + column)] =
          static_cast<float>(1.0 - share * (1.0 - light));
    }
  });
  if (stop && stop()) return {};
  blur(shadow);
  blur(shadow);
  return shadow;
}

}  // namespace boxprobe
