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

/// -x +x -y +y -z +z: red, green, blue by axis, darker for the negative side.
inline const std::array<glm::vec3, 6>& faceColors() {
  static const std::array<glm::vec3, 6> colors = {glm::vec3(0.55f, 0.12f, 0.10f), glm::vec3(0.95f, 0.42f, 0.38f),
                                                  glm::vec3(0.10f, 0.42f, 0.14f), glm::vec3(0.45f, 0.85f, 0.42f),
                                                  glm::vec3(0.10f, 0.22f, 0.60f), glm::vec3(0.45f, 0.65f, 0.98f)};
  return colors;
}

}  // namespace boxprobe
