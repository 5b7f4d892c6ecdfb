#include "filters/math/sampling/blue_noise.h"

#include "filters/math/sampling/void_and_cluster.h"

namespace boxprobe {

const std::vector<glm::vec2>& blueNoise() {
  static const std::vector<glm::vec2> mask = [] {
    const auto x = voidAndCluster(kBlueNoiseSize, 1), y = voidAndCluster(kBlueNoiseSize, 2);
    std::vector<glm::vec2> result;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result.push_back((glm::vec2(x[i], y[i]) + 0.5f) / static_cast<float>(x.size()));
    }
    return result;
  }();
  return mask;
}

glm::vec2 blueNoiseAt(const glm::ivec2& pixel) {
  const glm::ivec2 p = pixel & glm::ivec2(kBlueNoiseSize - 1);
  return blueNoise()[static_cast<std::size_t>(p.y * kBlueNoiseSize + p.x)];
}

}  // namespace boxprobe
