#include "filters/math/cube/lamp_free.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

namespace {

// What lies so much nearer than a lamp hides it; a texel's one distance is not that of all of it.
constexpr float kHidden = 0.03f;
// Points along a texel's side, to half a texel beyond it: samples of neighbours may have been blended in.
constexpr int kPoints = 5;

class LampView {
 public:
  // `margin`: radians.
  LampView(const LampPolygon& lamp, float margin) : lamp_(lamp) {
    const auto corner = [&](int i) { return lamp.corners[static_cast<std::size_t>(i)]; };
    glm::vec3 sum(0.0f);
    for (int i = 0; i < lamp.count; ++i) sum += corner(i);
    axis_ = glm::length(sum) > 0.0f ? glm::normalize(sum) : glm::vec3(1.0f, 0.0f, 0.0f);
    for (int i = 0; i < lamp.count; ++i) {
      const float size = glm::length(corner(i));
      cosine_ = size > 0.0f ? std::min(cosine_, glm::dot(corner(i), axis_) / size) : -1.0f;
    }
    reach_ = std::cos(std::min(std::acos(std::clamp(cosine_, -1.0f, 1.0f)) + margin, 3.1415f));
    normal_ = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    height_ = glm::dot(normal_, corner(0));
  }

  // Could a direction within the margin meet it?
  bool near(const glm::vec3& unit) const { return glm::dot(unit, axis_) >= reach_; }

  // Distance along the direction in its own lengths; negative: it does not meet the lamp's shining side.
  float meets(const glm::vec3& direction) const {
    const float along = glm::dot(normal_, direction);
    if (along == 0.0f || (along > 0.0f && !lamp_.bothSides)) return -1.0f;
    const float t = height_ / along;
    if (!(t > 0.0f)) return -1.0f;
    const glm::vec3 p = t * direction;
    for (int i = 0; i < lamp_.count; ++i) {
      const glm::vec3 a = lamp_.corners[static_cast<std::size_t>(i)];
      const glm::vec3 b = lamp_.corners[static_cast<std::size_t>((i + 1) % lamp_.count)];
      if (glm::dot(glm::cross(b - a, p - a), normal_) < 0.0f) return -1.0f;
    }
    return t;
  }

 private:
  const LampPolygon& lamp_;
  glm::vec3 axis_{0.0f}, normal_{0.0f};
  float cosine_ = 1.0f;  // of the corner farthest from the axis
  float reach_ = -1.0f;  // the same with the margin
  float height_ = 0.0f;
};

float coordinate(float index, int size) {
  return 2.0f * index / static_cast<float>(size) - 1.0f;
}

}  // namespace

CubeMap withoutLamps(const CubeMap& capture, const CubeMap& distance, const std::vector<LampPolygon>& lamps) {
  const int size = capture.faceSize();
  // The share of each texel that counts in alpha's place would need a fifth channel: a cube of its own.
  const int levels = fullLevels(size);
  CubeMap light(size, levels), counts(size, levels);
  const float texel = 4.0f / static_cast<float>(size);  // more than a texel's angle
  std::vector<LampView> views;
  for (const LampPolygon& lamp : lamps) {
    if (lamp.count >= 3) views.emplace_back(lamp, texel);
  }
  const auto seen = [&](const LampView& view, const glm::vec3& direction) {
    const float t = view.meets(direction);
    if (t < 0.0f) return false;
    if (distance.empty()) return true;
    const float found = distance.fetch(direction, 0.0f).x;
    return !(found > 0.0f) || found > (1.0f - kHidden) * t * glm::length(direction);
  };
  const auto shows = [&](int face, int row, int column) {
    const glm::vec3 middle = shading::cubeDirection(face, coordinate(static_cast<float>(column) + 0.5f, size),
                                                    coordinate(static_cast<float>(row) + 0.5f, size));
    const glm::vec3 unit = glm::normalize(middle);
    for (const LampView& view : views) {
      if (!view.near(unit)) continue;
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const float x = static_cast<float>(column) - 0.5f + 2.0f * static_cast<float>(i % kPoints) / (kPoints - 1);
        const float y = static_cast<float>(row) - 0.5f + 2.0f * static_cast<float>(i / kPoints) / (kPoints - 1);
        if (seen(view, shading::cubeDirection(face, coordinate(x, size), coordinate(y, size)))) return true;
      }
    }
    return false;
  };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const float counted = shows(face, row, column) ? 0.0f : 1.0f;
        light.setTexel(0, face, column, row, counted * capture.texel(0, face, column, row));
        counts.setTexel(0, face, column, row, glm::vec4(counted));
      }
    }
  }
  // Sums of the texels that count, level by level, and back down: a texel without any takes what its larger one has.
  glm::vec4 whole(0.0f), wholeCount(0.0f);
  for (int level = 1; level < levels; ++level) {
    const int own = light.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < own; ++row) {
        for (int column = 0; column < own; ++column) {
          glm::vec4 sum(0.0f), count(0.0f);
          for (int i = 0; i < 4; ++i) {
            sum += light.texel(level - 1, face, 2 * column + (i & 1), 2 * row + (i >> 1));
            count += counts.texel(level - 1, face, 2 * column + (i & 1), 2 * row + (i >> 1));
          }
          light.setTexel(level, face, column, row, sum);
          counts.setTexel(level, face, column, row, count);
        }
      }
    }
  }
  for (int face = 0; face < 6; ++face) {
    whole += light.texel(levels - 1, face, 0, 0);
    wholeCount += counts.texel(levels - 1, face, 0, 0);
  }
  const glm::vec4 mean = wholeCount.x > 0.0f ? whole / wholeCount.x : glm::vec4(0.0f);
  CubeMap result(size, 1);
  for (int level = levels - 1; level >= 0; --level) {
    const int own = light.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < own; ++row) {
        for (int column = 0; column < own; ++column) {
          const float count = counts.texel(level, face, column, row).x;
          const glm::vec4 value = count > 0.0f         ? light.texel(level, face, column, row) / count
                                  : level + 1 < levels ? light.texel(level + 1, face, column / 2, row / 2)
                                                       : mean;
          if (level > 0) {
            light.setTexel(level, face, column, row, value);
          } else {
            result.setTexel(0, face, column, row, value);
          }
        }
      }
    }
  }
  return result;
}

std::vector<glm::vec3> lampBackgrounds(const CubeMap& without, const std::vector<LampPolygon>& lamps) {
  std::vector<glm::vec3> backgrounds;
  for (const LampPolygon& lamp : lamps) {
    const auto corner = [&](int i) { return lamp.corners[static_cast<std::size_t>(i % lamp.count)]; };
    glm::vec3 middle(0.0f), sum(0.0f);
    float area = 0.0f;
    for (int i = 0; i < lamp.count; ++i) middle += corner(i) / static_cast<float>(lamp.count);
    for (int i = 0; i < lamp.count && !without.empty(); ++i) {  // of each triangle around the middle three points
      const glm::vec3 a = corner(i), b = corner(i + 1);
      const float weight = glm::length(glm::cross(a - middle, b - middle));
      for (int k = 0; k < 3; ++k) {
        const glm::vec3 share = glm::vec3(1.0f / 6.0f) + 0.5f * glm::vec3(k == 0, k == 1, k == 2);
        const glm::vec3 at = share.x * middle + share.y * a + share.z * b;
        if (!(glm::length(at) > 0.0f)) continue;
        sum += weight * glm::vec3(without.fetch(at, 0.0f));
        area += weight;
      }
    }
    backgrounds.push_back(area > 0.0f ? sum / area : glm::vec3(0.0f));
  }
  return backgrounds;
}

glm::vec3 withoutBackground(const glm::vec3& radiance, const glm::vec3& background) {
  return glm::max(radiance - background, glm::vec3(0.0f));
}

}  // namespace boxprobe
