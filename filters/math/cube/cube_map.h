// A cubemap with mip levels on the CPU, sampled exactly as OpenGL does with seamless filtering. Float RGBA.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

/// One texel and its weight in a lookup.
struct TexelShare {
  int level = 0;
  int face = 0;    ///< OpenGL order +X -X +Y -Y +Z -Z
  int column = 0;  ///< along s of shaders/shared/cube.glsl
  int row = 0;     ///< along t
  float share = 0.0f;
};

/// A point of a face, s and t in [-1, 1] along its columns and rows: the inverse of cubeDirection.
struct CubePoint {
  int face = 0;
  float s = 0.0f;
  float t = 0.0f;
};
/// `direction` need not be unit; a zero vector gives the middle of +X.
CubePoint cubePoint(const glm::vec3& direction);

/// Solid angle, steradian, of the rectangle of a face between two corners (s, t in [-1, 1]).
double cubeSolidAngle(double s0, double t0, double s1, double t1);

class CubeMap : public shading::CubeSampler {
 public:
  CubeMap() = default;
  /// All texels 0. Level l has `faceSize >> l` texels per side, at least 1.
  CubeMap(int faceSize, int levels);

  bool empty() const { return levels_.empty(); }
  int faceSize() const { return faceSize_; }
  int levels() const { return static_cast<int>(levels_.size()); }
  int levelSize(int level) const;
  float maxLevel() const { return static_cast<float>(levels() - 1); }

  /// levelSize² texels of RGBA float, rows along t: as glTexImage2D takes a face.
  float* face(int level, int face);
  const float* face(int level, int face) const;
  glm::vec4 texel(int level, int face, int column, int row) const;
  void setTexel(int level, int face, int column, int row, const glm::vec4& value);

  /// Trilinear, seamless; the three texels that meet at a corner of the cube share the missing fourth's weight.
  glm::vec4 fetch(const glm::vec3& direction, float level) const override;
  /// The texels of that lookup; shares sum to 1.
  std::vector<TexelShare> footprint(const glm::vec3& direction, float level) const;

 private:
  struct Taps;
  bool addInside(const CubePoint& point, int level, float weight, glm::vec4& sum) const;
  void tap(const glm::vec3& direction, int level, float weight, Taps& taps) const;
  Taps taps(const glm::vec3& direction, float level) const;

  int faceSize_ = 0;
  std::vector<std::vector<float>> levels_;  ///< six faces one after another
};

}  // namespace boxprobe
