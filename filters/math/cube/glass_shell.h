// The shell of a glass object: its surface as seen from its middle, a plane a texel of a cubemap, so that rays can be
// followed through it without its triangles. Made on the CPU from a mesh, once; uploaded by the VTK layer, looked up
// here by explanations. Right for what its middle sees all of (a ball, a block, a prism); `fits` says whether it does.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/math/shared/refraction.h"

namespace boxprobe {

class GlassShell : public shading::ShellSampler {
 public:
  /// Positions relative to the middle, outward normals (not all unit) one a position, triangles wound counter-clockwise
  /// from outside. `faceSize` texels per side.
  GlassShell(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
             const std::vector<std::uint32_t>& indices, int faceSize = 128);

  glm::vec4 fetchShell(const glm::vec3& direction) const override { return planes_.fetch(direction, 0.0f); }

  const CubeMap& planes() const { return planes_; }
  float radius() const { return radius_; }
  /// Share of the surface's area that faces away from the middle.
  double described() const { return described_; }
  /// Is that all of it, and is it closed?
  bool fits() const { return fits_; }

 private:
  void draw(const glm::vec3* corners, const glm::vec3* normals, int face);

  CubeMap planes_;
  std::vector<float> distance_;  ///< of each texel while it is drawn
  float radius_ = 0.0f;
  double described_ = 0.0;
  bool fits_ = false;
};

}  // namespace boxprobe
