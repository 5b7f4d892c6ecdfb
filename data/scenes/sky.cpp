// The gradient sky of building.boxprobe.json as a picture, for programs that take an image: same colours, same formula.
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {

std::string skyHdr() {
  constexpr int kWidth = 256, kHeight = 128;
  const glm::dvec3 top(0.08, 0.19, 0.46), horizon(0.66, 0.76, 0.88), ground(0.10, 0.12, 0.08);
  std::vector<float> rgb;
  for (int row = 0; row < kHeight; ++row) {
    const double y = std::cos(3.141592653589793 * (row + 0.5) / kHeight);
    const glm::dvec3 color = y < 0.0 ? blend(horizon, ground, -y) : blend(horizon, top, y);
    for (int column = 0; column < kWidth; ++column)
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(static_cast<float>(color[channel]));
  }
  return hdrBytes(kWidth, kHeight, rgb);
}

}  // namespace boxprobe::scenes
