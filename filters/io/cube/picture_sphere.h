// Pictures as texels of a sphere of directions: each has count, rgba(i), direction(i) (unit length), solidAngle(i) and
// pitch(), the angle between neighbours in its widest place, radians. Internal to this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_layout.h"

namespace boxprobe {

constexpr double kSpherePi = 3.14159265358979323846;

inline float brightestChannel(const float* rgb) {
  return std::max({rgb[0], rgb[1], rgb[2]});
}

/// A latitude-longitude map, texels at the centres of cells.
struct LatLongSphere {
  explicit LatLongSphere(ImageRgbaF& image) : pixels(image.pixels), width(static_cast<std::size_t>(image.width)) {
    count = pixels.size() / 4;
    for (int x = 0; x < image.width; ++x) {
      const double longitude = -kSpherePi * texelCoordinate(x, image.width, TexelPlacement::Centres);
      around.emplace_back(std::sin(longitude), 0.0, std::cos(longitude));
    }
    for (int y = 0; y < image.height; ++y) {
      const double upper = 0.5 * kSpherePi - kSpherePi * y / image.height,
                   lower = 0.5 * kSpherePi - kSpherePi * (y + 1) / image.height;
      const double latitude = 0.5 * (upper + lower);
      level.push_back(std::cos(latitude));
      up.push_back(std::sin(latitude));
      area.push_back(2.0 * kSpherePi / image.width * (std::sin(upper) - std::sin(lower)));
    }
  }
  float* rgba(std::size_t i) const { return &pixels[4 * i]; }
  glm::dvec3 direction(std::size_t i) const {
    const std::size_t row = i / width;
    const glm::dvec3& a = around[i % width];
    return {level[row] * a.x, up[row], level[row] * a.z};
  }
  double solidAngle(std::size_t i) const { return area[i / width]; }
  double pitch() const { return 2.0 * kSpherePi / static_cast<double>(width); }

  std::vector<float>& pixels;
  std::size_t width, count = 0;
  std::vector<glm::dvec3> around;
  std::vector<double> level, up, area;
};

/// Level 0 of a cubemap, OpenGL's faces.
struct CubeSphere {
  explicit CubeSphere(CubeMap& cube) : map(cube), size(static_cast<std::size_t>(cube.faceSize())) {
    count = 6 * size * size;
  }
  float* rgba(std::size_t i) const { return map.face(0, 0) + 4 * i; }
  glm::dvec3 onFace(std::size_t i) const {
    const std::size_t texel = i % (size * size);
    const auto along = [this](std::size_t at) {
      return static_cast<float>((2.0 * static_cast<double>(at) + 1.0) / static_cast<double>(size) - 1.0);
    };
    return shading::cubeDirection(static_cast<int>(i / (size * size)), along(texel % size), along(texel / size));
  }
  glm::dvec3 direction(std::size_t i) const { return glm::normalize(onFace(i)); }
  double solidAngle(std::size_t i) const {
    const glm::dvec3 d = onFace(i);
    const double square = glm::dot(d, d), side = 2.0 / static_cast<double>(size);
    return side * side / (square * std::sqrt(square));
  }
  double pitch() const { return 0.5 * kSpherePi / static_cast<double>(size); }

  CubeMap& map;
  std::size_t size, count = 0;
};

}  // namespace boxprobe
