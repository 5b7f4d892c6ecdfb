#include "filters/math/cube/relief.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace boxprobe {

namespace {

/// Positions of a face's texels and their reciprocal depths: across a plane these are linear along rows and columns.
class Face {
 public:
  Face(const CubeMap& distance, int face)
      : size_(distance.faceSize()), depth_(static_cast<std::size_t>(size_ * size_)) {
    for (int row = 0; row < size_; ++row) {
      for (int column = 0; column < size_; ++column) {
        // Below this the reciprocal overflows.
        constexpr float kNearest = 1.0e-30f;
        const float seen = distance.texel(0, face, column, row).x;
        const float length = glm::length(shading::cubeDirection(face, at(column), at(row)));
        depth_[index(column, row)] = seen > kNearest && seen < 1.0e30f ? length / seen : 0.0f;
      }
    }
  }
  float at(int i) const { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size_) - 1.0f; }
  float depth(int column, int row) const { return depth_[index(column, row)]; }

  /// Change of reciprocal depth per unit of s or t. At a depth edge, that of the side which continues more evenly.
  float slope(int column, int row, int dx, int dy) const {
    const float here = depth(column, row);
    float best = 0.0f, least = 1.0e38f;
    for (const int side : {-1, 1}) {
      const int x = column + side * dx, y = row + side * dy;
      if (!inside(x, y) || depth(x, y) <= 0.0f) continue;
      const float step = depth(x, y) - here;
      const int x2 = x + side * dx, y2 = y + side * dy;
      // At the face's border there is no second step to compare with: half of the first, so that the other side is
      // preferred.
      const float bend = inside(x2, y2) ? std::abs(depth(x2, y2) - depth(x, y) - step) : 0.5f * std::abs(step);
      const float score = bend + 1.0e-3f * std::abs(step);
      if (score >= least) continue;
      least = score;
      best = static_cast<float>(side) * step;
    }
    return 0.5f * best * static_cast<float>(size_);
  }

 private:
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < size_ && y < size_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column);
  }

  int size_;
  std::vector<float> depth_;
};

/// Beyond this many times the median distance something counts as far: seen from the lookup's position it lies in the
/// same direction as from the origin, within a few degrees.
constexpr float kFarShare = 4.0f;

float farDistance(const CubeMap& distance) {
  std::vector<float> seen;
  const int size = distance.faceSize(), step = std::max(1, size / 32);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; row += step) {
      for (int column = 0; column < size; column += step) {
        const float d = distance.texel(0, face, column, row).x;
        if (d > 0.0f) seen.push_back(d);
      }
    }
  }
  if (seen.empty()) return 0.0f;
  const auto middle = seen.begin() + static_cast<long>(seen.size() / 2);
  std::nth_element(seen.begin(), middle, seen.end());
  return kFarShare * *middle;
}

/// Finds the nearest direction in which something far was seen. Skies and horizons change more with height than around,
/// so elevation counts three times.
class FarDirections {
 public:
  FarDirections(const CubeMap& distance, float far) : distance_(distance), far_(far), size_(distance.faceSize()) {
    step_ = std::max(1, size_ / kCells);
    for (int face = 0; face < 6; ++face) {
      for (int row = step_ / 2; row < size_; row += step_) {
        for (int column = step_ / 2; column < size_; column += step_) {
          if (isFar(face, column, row)) found_.push_back(direction(face, column, row));
        }
      }
    }
  }
  bool isFar(int face, int column, int row) const {
    const float d = distance_.texel(0, face, column, row).x;
    return d <= 0.0f || d > far_;
  }
  int step() const { return step_; }
  float nearest(int face, int column, int row) const {
    const glm::vec3 w = direction(face, column, row);
    float least = 1.0e38f;
    const glm::vec3* best = nullptr;
    for (const glm::vec3& v : found_) {
      const glm::vec3 d = v - w;
      const float apart = d.x * d.x + kHeight * kHeight * d.y * d.y + d.z * d.z;
      if (apart >= least) continue;
      least = apart;
      best = &v;
    }
    return best != nullptr ? Relief::farCode(*best) : Relief::kNowhere;
  }

 private:
  static constexpr int kCells = 32;  // along a face: the search is quadratic in them
  static constexpr float kHeight = 3.0f;
  glm::vec3 direction(int face, int column, int row) const {
    const auto at = [this](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size_) - 1.0f; };
    return glm::normalize(shading::cubeDirection(face, at(column), at(row)));
  }

  const CubeMap& distance_;
  float far_;
  int size_, step_ = 1;
  std::vector<glm::vec3> found_;
};

}  // namespace

float Relief::farCode(const glm::vec3& direction) {
  const glm::vec3 d = direction / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
  glm::vec2 p(d.x, d.z);
  if (d.y < 0.0f) {
    p = glm::vec2((1.0f - std::abs(d.z)) * (d.x < 0.0f ? -1.0f : 1.0f),
                  (1.0f - std::abs(d.x)) * (d.z < 0.0f ? -1.0f : 1.0f));
  }
  const auto cell = [](float v) { return std::clamp(std::floor((0.5f * v + 0.5f) * 4096.0f), 0.0f, 4095.0f); };
  return cell(p.x) + 4096.0f * cell(p.y);
}

Relief::Relief(const CubeMap& distance) : texels_(distance.faceSize(), 1) {
  const int size = distance.faceSize();
  const FarDirections far(distance, farDistance(distance));
  for (int f = 0; f < 6; ++f) {
    const Face face(distance, f);
    const glm::vec3 middle = shading::cubeDirection(f, 0.0f, 0.0f);
    const glm::vec3 alongS = shading::cubeDirection(f, 1.0f, 0.0f) - middle;
    const glm::vec3 alongT = shading::cubeDirection(f, 0.0f, 1.0f) - middle;
    const int step = far.step(), cells = (size + step - 1) / step;
    std::vector<float> nearest(static_cast<std::size_t>(cells * cells), 0.0f);  // 0 encodes a corner: made when needed
    std::vector<bool> made(nearest.size());
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        glm::vec4 texel(0.0f, 0.0f, 0.0f, kHere);
        const float depth = face.depth(column, row);
        if (depth > 0.0f) {
          const float s = face.slope(column, row, 1, 0), t = face.slope(column, row, 0, 1);
          const glm::vec3 plane = (depth - s * face.at(column) - t * face.at(row)) * middle + s * alongS + t * alongT;
          texel = glm::vec4(plane, kHere);
        }
        if (!far.isFar(f, column, row)) {
          const int place = row / step * cells + column / step;
          const auto cell = static_cast<std::size_t>(place);
          if (!made[cell]) nearest[cell] = far.nearest(f, column, row);
          made[cell] = true;
          texel.w = nearest[cell];
        }
        texels_.setTexel(0, f, column, row, texel);
      }
    }
  }
}

const CubeMap& Relief::bounds() const {
  std::call_once(bounded_, [this] { bounds_ = reliefBounds(texels_); });
  return bounds_;
}

glm::vec4 Relief::fetchRelief(const glm::vec3& direction, float level) const {
  const CubePoint point = cubePoint(direction);
  const int above = static_cast<int>(level) - 1;
  const CubeMap& map = above < 0 ? texels_ : bounds();
  const int size = map.levelSize(std::max(above, 0));
  const auto index = [size](float x) {
    return std::clamp(static_cast<int>((0.5f * x + 0.5f) * static_cast<float>(size)), 0, size - 1);
  };
  return map.texel(std::max(above, 0), point.face, index(point.s), index(point.t));
}

std::shared_ptr<const Relief> LazyRelief::of(const CubeMap& distance) const {
  auto relief = std::atomic_load(&relief_);
  if (!relief) {
    relief = std::make_shared<const Relief>(distance);
    std::atomic_store(&relief_, relief);
  }
  return relief;
}

std::shared_ptr<const ReliefBlocks> LazyRelief::blocks(const Relief& relief, const glm::vec3& boxMin,
                                                       const glm::vec3& boxMax, const glm::mat3& mapFromProbe) const {
  auto kept = std::atomic_load(&blocks_);
  if (!kept || kept->boxMin != boxMin || kept->boxMax != boxMax || kept->mapFromProbe != mapFromProbe) {
    kept = std::make_shared<const OfBox>(
        OfBox{boxMin, boxMax, mapFromProbe, reliefBlocks(relief, boxMin, boxMax, mapFromProbe)});
    std::atomic_store(&blocks_, kept);
  }
  return {kept, &kept->blocks};
}

std::shared_ptr<const ReliefBlocks> LazyRelief::latestBlocks() const {
  const auto kept = std::atomic_load(&blocks_);
  return kept ? std::shared_ptr<const ReliefBlocks>(kept, &kept->blocks) : nullptr;
}

}  // namespace boxprobe
