// Blocks from what a probe saw: texels whose surface stands off the box's walls are gathered in a grid, cells that
// touch form one piece, and each piece gets a box. Deterministic: cells are joined in the grid's order.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <unordered_map>
#include <vector>

#include "filters/math/cube/relief.h"

namespace boxprobe {

namespace {

constexpr int kCells = 48;  // along the longest side: finer than gaps between furniture, coarser than between texels
constexpr float kOffWall = 0.02f;  // of the box's shortest side: skirtings, door frames and noise stay part of the wall
constexpr float kInflate = 0.005f;     // of the same: gives a flat piece an inside to sample
constexpr float kBeyond = 0.25f;       // of the same: pillars and beams this close behind a wall are part of it
constexpr float kOutsideCells = 2.0f;  // cells are this much larger outside the box, where surfaces are farther away
constexpr float kFacing = 0.35f;  // cosine: flatter surfaces are ground, which would join everything that stands on it
constexpr double kSmallest = 2.0e-4;  // of the sphere of directions: smaller blocks cover few pixels but cost every ray

struct Piece {
  glm::vec3 low{1.0e38f}, high{-1.0e38f};
  double solidAngle = 0.0;
  void add(const Piece& o) {
    low = glm::min(low, o.low);
    high = glm::max(high, o.high);
    solidAngle += o.solidAngle;
  }
};

/// A grid of cubes around the capture origin; cubes that touch form one piece.
class Cells {
 public:
  explicit Cells(float size) : size_(size) {}

  void add(const glm::vec3& p, double solidAngle) {
    const glm::ivec3 at(glm::floor(p / size_));
    const auto [place, isNew] = number_.emplace(keyOf(at), pieces_.size());
    if (isNew) {
      at_.push_back(at);
      pieces_.emplace_back();
    }
    pieces_[place->second].add({p, p, solidAngle});
  }

  std::vector<Piece> joined() const {
    std::vector<std::size_t> parent(pieces_.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    for (std::size_t i = 0; i < parent.size(); ++i) {
      for (int n = 0; n < 27; ++n) {
        const auto found = number_.find(keyOf(at_[i] + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1)));
        if (found != number_.end()) parent[rootOf(parent, i)] = rootOf(parent, found->second);
      }
    }
    std::vector<Piece> sums(parent.size());
    for (std::size_t i = 0; i < parent.size(); ++i) sums[rootOf(parent, i)].add(pieces_[i]);
    return sums;
  }

 private:
  static std::int64_t keyOf(const glm::ivec3& c) {
    constexpr std::int64_t kRow = 1 << 20;
    return (c.z * kRow + c.y) * kRow + c.x;
  }
  static std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }

  float size_;
  std::unordered_map<std::int64_t, std::size_t> number_;  ///< of a cell among those that hold something
  std::vector<glm::ivec3> at_;
  std::vector<Piece> pieces_;
};

struct Seen {
  Cells inside, outside;
};

Seen gather(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax, const glm::mat3& mapFromProbe,
            float cell, float offWall) {
  Seen seen{Cells(cell), Cells(kOutsideCells * cell)};
  const float beyond = offWall * (kBeyond / kOffWall);
  const CubeMap& map = relief.texels();
  const int size = map.faceSize();
  const glm::mat3 probeFromMap = glm::transpose(mapFromProbe);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto at = [size](int i) {
          return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f;
        };
        const glm::vec3 w = shading::cubeDirection(face, at(column), at(row));
        const glm::vec4 texel = map.texel(0, face, column, row);
        const glm::vec3 plane(texel);
        const float reciprocal = glm::dot(plane, w), square = glm::dot(w, w);
        if (reciprocal <= 0.0f) continue;
        const glm::vec3 p = probeFromMap * (w / reciprocal);
        const glm::vec3 a = p - boxMin, b = boxMax - p;
        const float in = std::min({a.x, a.y, a.z, b.x, b.y, b.z});
        const double solidAngle = 4.0 / (static_cast<double>(size) * size * square * std::sqrt(square));
        if (in > offWall) {
          seen.inside.add(p, solidAngle);
        } else if (in < -beyond && texel.w != Relief::kHere &&
                   reciprocal * reciprocal > kFacing * kFacing * glm::dot(plane, plane) * square) {
          seen.outside.add(p, solidAngle);
        }
      }
    }
  }
  return seen;
}

}  // namespace

ReliefBlocks reliefBlocks(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax,
                          const glm::mat3& mapFromProbe) {
  ReliefBlocks blocks;
  const glm::vec3 size = boxMax - boxMin;
  const float longest = std::max({size.x, size.y, size.z}), shortest = std::min({size.x, size.y, size.z});
  // A flat box has no interior; squares of larger boxes overflow a float.
  if (!(shortest > 1.0e-6f * longest) || !(longest < 1.0e15f) || !(longest > 1.0e-15f)) return blocks;
  const float cell = longest / kCells, offWall = kOffWall * shortest;
  const Seen seen = gather(relief, boxMin, boxMax, mapFromProbe, cell, offWall);
  std::vector<Piece> pieces = seen.inside.joined();
  for (Piece& piece : pieces) {
    // What stands at a wall extends to it: the texels that would show this count as wall.
    const float reach = 2.5f * offWall + 0.5f * cell;
    for (int axis = 0; axis < 3; ++axis) {
      if (piece.low[axis] - boxMin[axis] < reach) piece.low[axis] = boxMin[axis];
      if (boxMax[axis] - piece.high[axis] < reach) piece.high[axis] = boxMax[axis];
    }
  }
  for (const Piece& piece : seen.outside.joined()) {
    const glm::vec3 low = piece.low, high = piece.high;
    const bool around = low.x < 0.0f && low.y < 0.0f && low.z < 0.0f && high.x > 0.0f && high.y > 0.0f && high.z > 0.0f;
    if (!around) pieces.push_back(piece);
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.solidAngle > b.solidAngle; });
  for (const Piece& piece : pieces) {
    if (blocks.count == ReliefBlocks::kMost || !(piece.solidAngle > kSmallest * 4.0 * 3.14159265358979)) break;
    blocks.low[static_cast<std::size_t>(blocks.count)] = piece.low - kInflate * shortest;
    blocks.high[static_cast<std::size_t>(blocks.count)] = piece.high + kInflate * shortest;
    ++blocks.count;
  }
  return blocks;
}

}  // namespace boxprobe
