// The shell of a glass object: its surface seen from its middle, one plane per texel of a cubemap, so that rays can be
// followed through it without its triangles. Made once from a mesh on the CPU and uploaded as a texture; explanations
// sample it here. Exact for objects whose surface is entirely visible from the middle (a ball, a block, a prism);
// `fits` says whether it is.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/shared/refraction.h"

namespace boxprobe {

class GlassShell : public shading::ShellSampler {
 public:
  /// Positions relative to the middle; one outward normal per position, of any length; triangles wound
  /// counter-clockwise from outside. `faceSize`: texels per side.
  GlassShell(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
             const std::vector<std::uint32_t>& indices, int faceSize = 128);

  glm::vec4 fetchShell(const glm::vec3& direction) const override { return planes_.fetch(direction, 0.0f); }

  const CubeMap& planes() const { return planes_; }
  float radius() const { return radius_; }
  /// Share of the surface's area that faces away from the middle.
  double described() const { return described_; }
  /// Does the shell describe the whole object, and is it closed?
  bool fits() const { return fits_; }

 private:
  void draw(const glm::vec3* corners, const glm::vec3* normals, int face);

  CubeMap planes_;
  std::vector<float> distance_;  ///< of each texel while triangles are drawn
  float radius_ = 0.0f;
  double described_ = 0.0;
  bool fits_ = false;
};

}  // namespace boxprobe
