// What a probe's distance cubemap says about the shape of its surroundings, prepared for following rays with few
// lookups: the plane of the surface in every texel, where to look instead for what lies far away, and the blocks that
// stand in the box. Called by explanations, the ray filter and, through a texture, by the shader of projection
// `impostor`; knows no probe.
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
  /// `distance`: the red channel holds distances from the capture origin, 0 where nothing was seen.
  explicit Relief(const CubeMap& distance);

  /// xyz: the plane {x : dot(q, x) = 1} of what the nearest texel shows, axes of the map, 1 / scene units; 0 where it
  /// saw nothing. w: farCode() of the direction to look in for what lies far away along this one; kNowhere if nothing
  /// far was seen.
  /// From level 1 on, a texel covers a block of level 0. xyz is then a plane that nothing in the block lies before, in
  /// the same units; w, at least 0: what the block shows has a reciprocal depth at most w below that plane's. Depth is
  /// along the axis of the cube's face.
  glm::vec4 fetchRelief(const glm::vec3& direction, float level) const override;
  float reliefSize() const override { return static_cast<float>(texels_.faceSize()); }

  /// One level, the four numbers of each texel.
  const CubeMap& texels() const { return texels_; }
  /// The levels from 1 on, made at the first call, here or by a fetch of them; safe from several threads.
  const CubeMap& bounds() const;

  static constexpr float kNowhere = -1.0f;  ///< all that was seen is near
  static constexpr float kHere = -2.0f;     ///< the texel itself shows something far, or nothing
  /// A direction in 24 bits, which a float holds exactly: an octahedron unfolded to 4096 x 4096 (Cigolle et al. 2014).
  /// Decoded by reliefDirection() of shaders/shared/relief.glsl.
  static float farCode(const glm::vec3& direction);

 private:
  CubeMap texels_;
  mutable std::once_flag bounded_;
  mutable CubeMap bounds_;
};

/// Those levels, of the texels of a relief: a power of two along a face. Its level 0 is the relief's 1.
CubeMap reliefBounds(const CubeMap& texels);

/// Boxes, in the probe's frame and axes, around what stands between the capture origin and the walls of the projection
/// box: connected pieces of what was seen, largest first as seen from the origin.
struct ReliefBlocks {
  static constexpr int kMost = 8;
  int count = 0;
  std::array<glm::vec3, kMost> low{}, high{};
};
ReliefBlocks reliefBlocks(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax,
                          const glm::mat3& mapFromProbe);

/// Both, of a map that may never be asked for them. Copies share what has been made; safe from several threads.
class LazyRelief {
 public:
  std::shared_ptr<const Relief> of(const CubeMap& distance) const;
  /// Made again when the box is another one than at the last call.
  std::shared_ptr<const ReliefBlocks> blocks(const Relief& relief, const glm::vec3& boxMin, const glm::vec3& boxMax,
                                             const glm::mat3& mapFromProbe) const;
  /// Of whichever box they were last made for; null if of none.
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
