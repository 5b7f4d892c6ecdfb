// The relief's levels: all surfaces in a block of 2^n x 2^n texels lie between two planes. Reciprocal depth is linear
// across a plane and along a ray, so a block is bounded by a linear function of s and t and a slack. A plane wall has
// no slack, however obliquely it is seen.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/cube/relief.h"

namespace boxprobe {

namespace {

/// Reciprocal depth at (s, t) of a face: at most start + s * alongS + t * alongT, at least that less the slack.
struct Bound {
  float start = 0.0f, alongS = 0.0f, alongT = 0.0f, slack = 0.0f;
  float slope(float s, float t) const { return s * alongS + t * alongT; }
};

struct FaceAxes {
  glm::vec3 middle, s, t;
  explicit FaceAxes(int face)
      : middle(shading::cubeDirection(face, 0.0f, 0.0f)),
        s(shading::cubeDirection(face, 1.0f, 0.0f) - middle),
        t(shading::cubeDirection(face, 0.0f, 1.0f) - middle) {}
  Bound bound(const glm::vec4& texel, bool hasSlack) const {
    const glm::vec3 plane(texel);
    return {glm::dot(plane, middle), glm::dot(plane, s), glm::dot(plane, t), hasSlack ? texel.w : 0.0f};
  }
  glm::vec4 texel(const Bound& b) const { return glm::vec4(b.start * middle + b.alongS * s + b.alongT * t, b.slack); }
};

/// Of the slopes of the four parts, the one that leaves the least slack.
Bound joined(const std::array<Bound, 4>& parts, const glm::vec2& low, float side) {
  Bound best;
  best.slack = 3.0e38f;
  for (const Bound& like : parts) {
    float most = -3.0e38f, least = 3.0e38f;
    for (int i = 0; i < 4; ++i) {
      const Bound& part = parts[static_cast<std::size_t>(i)];
      for (int corner = 0; corner < 4; ++corner) {
        const float s = low.x + side * static_cast<float>((i & 1) + (corner & 1));
        const float t = low.y + side * static_cast<float>((i >> 1) + (corner >> 1));
        const float beyond = part.start + part.slope(s, t) - like.slope(s, t);
        most = std::max(most, beyond);
        least = std::min(least, beyond - part.slack);
      }
    }
    if (most - least < best.slack) best = {most, like.alongS, like.alongT, most - least};
  }
  return best;
}

}  // namespace

CubeMap reliefBounds(const CubeMap& texels) {
  int levels = 0;
  while (texels.faceSize() >> (levels + 1) > 0 && (texels.faceSize() >> levels) % 2 == 0) ++levels;
  CubeMap bounds(std::max(texels.faceSize() / 2, 1), std::max(levels, 1));
  for (int face = 0; face < 6; ++face) {
    const FaceAxes axes(face);
    for (int level = 0; level < levels; ++level) {
      const CubeMap& finer = level == 0 ? texels : bounds;
      const int size = bounds.levelSize(level);
      const float side = 1.0f / static_cast<float>(size);  // of a part
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          std::array<Bound, 4> parts;
          for (int i = 0; i < 4; ++i) {
            parts[static_cast<std::size_t>(i)] = axes.bound(
                finer.texel(std::max(level - 1, 0), face, 2 * column + (i & 1), 2 * row + (i >> 1)), level > 0);
          }
          const glm::vec2 low(2.0f * static_cast<float>(column) * side - 1.0f,
                              2.0f * static_cast<float>(row) * side - 1.0f);
          bounds.setTexel(level, face, column, row, axes.texel(joined(parts, low, side)));
        }
      }
    }
  }
  return bounds;
}

}  // namespace boxprobe
