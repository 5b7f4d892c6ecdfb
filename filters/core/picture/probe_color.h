// The colours that distinguish probes and box faces in views, rays and legends.
#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Display colours. Hues follow the golden ratio: neighbours in the list differ strongly, and a new probe changes no
/// other's colour.
inline glm::vec3 probeColor(int index) {
  const double hue = std::fmod(0.58 + index * 0.6180339887498949, 1.0);
  const auto channel = [hue](double shift) {
    const double x = std::fmod(6.0 * hue + shift, 6.0);
    const double ramp = std::fmin(std::fmax(std::fmin(x, 4.0 - x), 0.0), 1.0);
    return static_cast<float>(0.95 - 0.7 * ramp);
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

inline glm::vec3 skyColor() {
  return glm::vec3(0.22f);
}

/// -x +x -y +y -z +z: red, green, blue by axis. Darker for the negative side, so that they differ under colour
/// blindness, too (CIE 1976 difference of at least 20, simulated after Machado et al. 2009;
/// tests/gui/color_vision_test.cpp).
inline const std::array<glm::vec3, 6>& faceColors() {
  static const std::array<glm::vec3, 6> colors = {glm::vec3(0.345f, 0.000f, 0.008f), glm::vec3(0.804f, 0.584f, 0.596f),
                                                  glm::vec3(0.000f, 0.502f, 0.016f), glm::vec3(0.016f, 0.953f, 0.094f),
                                                  glm::vec3(0.208f, 0.196f, 0.553f), glm::vec3(0.584f, 0.620f, 0.957f)};
  return colors;
}

}  // namespace boxprobe
