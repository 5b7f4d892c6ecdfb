// The shape of a probe's surroundings, from its distance cubemap, prepared for following rays with few lookups: the
// plane of the surface in every texel, the direction to sample for what lies far away, and the blocks that stand in the
// box. The projection `impostor` reads it from a texture.
#pragma once

#include <array>
#include <atomic>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <mutex>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class Relief : public shading::ReliefSampler {
 public:
  /// `distance`: distances from the capture origin in the red channel, 0 where nothing was seen.
  explicit Relief(const CubeMap& distance);

  /// xyz: the plane {x : dot(q, x) = 1} of what the nearest texel shows, in the map's axes, 1 / scene units; 0 where
  /// nothing was seen. w: farCode() of the direction to sample for what lies far away along this one; kNowhere if
  /// nothing far was seen.
  ///
  /// From level 1 on, a texel covers a block of level 0. xyz is then a plane in front of which nothing in the block
  /// lies, in the same units; w >= 0 bounds how far the reciprocal depths of the block lie below that plane's. Depth is
  /// along the axis of the cube's face.
  glm::vec4 fetchRelief(const glm::vec3& direction, float level) const override;
  float reliefSize() const override { return static_cast<float>(texels_.faceSize()); }

  /// One level; the four numbers of each texel.
  const CubeMap& texels() const { return texels_; }
  /// The levels from 1 on, made at the first call or fetch; thread-safe.
  const CubeMap& bounds() const;

  static constexpr float kNowhere = -1.0f;  ///< everything that was seen is near
  static constexpr float kHere = -2.0f;     ///< this texel itself shows something far, or nothing
  /// A direction in 24 bits, which a float holds exactly: an octahedron unfolded to 4096 x 4096 (Cigolle et al. 2014).
  /// reliefDirection() of shaders/shared/relief.glsl decodes it.
  static float farCode(const glm::vec3& direction);

 private:
  CubeMap texels_;
  mutable std::once_flag bounded_;
  mutable CubeMap bounds_;
};

/// Levels 1 and up of a relief, from its texels; the face size must be a power of two. Level 0 of the result is level 1
/// of the relief.
CubeMap reliefBounds(const CubeMap& texels);

/// Boxes, in the probe's frame and axes, around what stands between the capture origin and the walls of the projection
/// box: connected pieces of what was seen, in order of decreasing size as seen from the origin.
struct ReliefBlocks {
  static constexpr int kMost = 8;
  int count = 0;
  std::array<glm::vec3, kMost> low{}, high{};
};
ReliefBlocks reliefBlocks(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax,
                          const glm::mat3& mapFromProbe);

/// Makes relief and blocks at the first use, since few maps need them. Copies share what was made; thread-safe.
class LazyRelief {
 public:
  std::shared_ptr<const Relief> of(const CubeMap& distance) const;
  /// Made again when the box differs from that of the last call.
  std::shared_ptr<const ReliefBlocks> blocks(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax,
                                             const glm::mat3& mapFromProbe) const;
  /// Those of the last call to blocks(); null before the first.
  std::shared_ptr<const ReliefBlocks> latestBlocks() const;

 private:
  struct OfBox {
    glm::vec3 boxMin, boxMax;
    glm::mat3 mapFromProbe;
    ReliefBlocks blocks;
  };
  mutable std::shared_ptr<const Relief> relief_;
  mutable std::shared_ptr<const OfBox> blocks_;
};

}  // namespace boxprobe
