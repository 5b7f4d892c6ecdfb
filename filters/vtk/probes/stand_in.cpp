// See stand_in.h.
#include "filters/vtk/probes/stand_in.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <variant>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/cube/cube_filter.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

namespace {

constexpr int kFaceSize = 16;
constexpr int kColumns = 24, kRows = 12;  // that a sky's picture is averaged to

/// Means of a latitude-longitude picture's blocks.
std::vector<glm::vec3> blocks(const ImageRgbaF& image) {
  std::vector<glm::vec3> means;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      glm::vec3 sum(0.0f);
      int count = 0;
      const int bottom = std::max((row + 1) * image.height / kRows, row * image.height / kRows + 1);
      const int right = std::max((column + 1) * image.width / kColumns, column * image.width / kColumns + 1);
      for (int y = row * image.height / kRows; y < std::min(bottom, image.height); ++y) {
        for (int x = column * image.width / kColumns; x < std::min(right, image.width); ++x) {
          const float* texel = &image.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                                  static_cast<std::size_t>(x))];
          sum += glm::vec3(texel[0], texel[1], texel[2]);
          ++count;
        }
      }
      means.push_back(count > 0 ? sum / static_cast<float>(count) : glm::vec3(0.0f));
    }
  }
  return means;
}

class BlurredSky {
 public:
  BlurredSky(const Scene& scene, const ImageRgbaF* image) : turn_(-glm::radians(scene.skyRotationDegrees)) {
    if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) gradient_ = *gradient;
    if (const auto* color = std::get_if<SkyColor>(&scene.sky)) gradient_ = {color->color, color->color, color->color};
    if (image != nullptr && image->width > 0 && image->height > 0) blocks_ = blocks(*image);
  }

  glm::vec3 operator()(const glm::dvec3& world) const {
    const glm::dvec3 d(world.x * std::cos(turn_) + world.z * std::sin(turn_), world.y,
                       world.z * std::cos(turn_) - world.x * std::sin(turn_));
    if (blocks_.empty()) {
      return shading::skyGradient(glm::vec3(d), gradient_.top, gradient_.horizon, gradient_.ground);
    }
    constexpr double kPi = 3.14159265358979323846;
    const double across = 0.5 - std::atan2(d.x, d.z) / (2.0 * kPi);
    const double down = 0.5 - std::asin(std::clamp(d.y / glm::length(d), -1.0, 1.0)) / kPi;
    const int column = std::clamp(static_cast<int>(across * kColumns), 0, kColumns - 1);
    const int row = std::clamp(static_cast<int>(down * kRows), 0, kRows - 1);
    return blocks_[static_cast<std::size_t>(row * kColumns + column)];
  }

 private:
  double turn_;
  SkyGradient gradient_{};
  std::vector<glm::vec3> blocks_;
};

}  // namespace

BakedMaps standInMaps(const Scene& scene, const ImageRgbaF* image, const Probe& probe) {
  const BlurredSky sky(scene, image);
  const glm::dmat3 worldFromMap = rotationMatrix(probe.rotationDegrees);
  const bool open = std::holds_alternative<ClearToOpen>(probe.clear);
  CubeMap capture(kFaceSize, fullLevels(kFaceSize));
  double mean = 0.0;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < kFaceSize; ++row) {
      for (int column = 0; column < kFaceSize; ++column) {
        const float s = (2.0f * static_cast<float>(column) + 1.0f) / kFaceSize - 1.0f;
        const float t = (2.0f * static_cast<float>(row) + 1.0f) / kFaceSize - 1.0f;
        const glm::dvec3 direction = glm::normalize(glm::dvec3(shading::cubeDirection(face, s, t)));
        const glm::vec3 light = sky(worldFromMap * direction);
        mean += static_cast<double>(light.x + light.y + light.z) / (3.0 * 6 * kFaceSize * kFaceSize);
        capture.setTexel(0, face, column, row, open ? glm::vec4(0.0f) : glm::vec4(light, 1.0f));
      }
    }
  }
  constexpr double kSeen = 0.05, kGrey = 0.2;
  if (!open && mean * scene.exposure < kSeen) {
    const auto grey = static_cast<float>(kGrey / std::max(scene.exposure, 1.0e-9));
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < kFaceSize; ++row) {
        for (int column = 0; column < kFaceSize; ++column) {
          capture.setTexel(0, face, column, row, glm::vec4(grey, grey, grey, 1.0f));
        }
      }
    }
  }
  BakedMaps maps;
  maps.radiance = prefilterCube(capture, {});
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) {
    const float* texels = capture.face(0, face);
    faces[static_cast<std::size_t>(face)].assign(texels, texels + 4 * kFaceSize * kFaceSize);
  }
  maps.irradiance = irradianceCoefficients(faces, kFaceSize, worldFromMap);
  maps.capturedAt = probe.origin;
  maps.capturedRotation = probe.rotationDegrees;
  return maps;
}

}  // namespace boxprobe
