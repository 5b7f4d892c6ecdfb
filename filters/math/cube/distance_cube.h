// A distance cubemap on the CPU, sampled as on the GPU: the nearest texel.
#pragma once

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

class DistanceCube : public shading::DistanceSampler {
 public:
  /// `distance` must outlive this object; its red channel holds the distances, 0 where nothing was seen.
  explicit DistanceCube(const CubeMap& distance) : distance_(distance) {}
  float fetchDistance(const glm::vec3& direction) const override {
    const CubePoint point = cubePoint(direction);
    const int size = distance_.faceSize();
    const auto index = [size](float x) {
      const int i = static_cast<int>((0.5f * x + 0.5f) * static_cast<float>(size));
      return i < 0 ? 0 : (i >= size ? size - 1 : i);
    };
    return distance_.texel(0, point.face, index(point.s), index(point.t)).x;
  }

 private:
  const CubeMap& distance_;
};

}  // namespace boxprobe
