#include "filters/math/cube/glass_shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

// Rounding leaves a few texels along triangle edges uncovered; a shell with more has a hole.
constexpr double kOpenShare = 1.0e-3;
// At least this share of the surface must face away from the middle: a dent may take one hundredth.
constexpr double kDescribedShare = 0.99;

}  // namespace

GlassShell::GlassShell(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
                       const std::vector<std::uint32_t>& indices, int faceSize)
    : planes_(faceSize, 1), distance_(static_cast<std::size_t>(faceSize) * static_cast<std::size_t>(faceSize) * 6) {
  for (const glm::vec3& p : positions) radius_ = std::max(radius_, glm::length(p));
  double area = 0.0, outward = 0.0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::array<glm::vec3, 3> corners, corner_normals;
    for (std::size_t k = 0; k < 3; ++k) corners.at(k) = positions[indices[i + k]];
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = 0.5 * static_cast<double>(glm::length(across));
    if (!(size > 0.0)) continue;
    area += size;
    if (glm::dot(across, corners[0]) <= 0.0f) continue;
    outward += size;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool given = indices[i + k] < normals.size();
      const glm::vec3 n = given ? normals[indices[i + k]] : across;
      const float length = glm::length(n);
      corner_normals.at(k) = length > 0.0f ? n / length : glm::normalize(across);
    }
    for (int face = 0; face < 6; ++face) draw(corners.data(), corner_normals.data(), face);
  }
  described_ = area > 0.0 ? outward / area : 0.0;

  std::size_t open = 0;
  const auto texels = static_cast<std::size_t>(faceSize) * static_cast<std::size_t>(faceSize);
  for (std::size_t i = 0; i < distance_.size(); ++i) {
    if (distance_[i] > 0.0f) continue;
    ++open;
    // Filled with the bounding sphere.
    const auto at = static_cast<int>(i % texels);
    const float s = 2.0f * (static_cast<float>(at % faceSize) + 0.5f) / static_cast<float>(faceSize) - 1.0f;
    const float t = 2.0f * (static_cast<float>(at / faceSize) + 0.5f) / static_cast<float>(faceSize) - 1.0f;
    const auto face = static_cast<int>(i / texels);
    planes_.setTexel(0, face, at % faceSize, at / faceSize,
                     glm::vec4(glm::normalize(shading::cubeDirection(face, s, t)), radius_));
  }
  fits_ =
      described_ > kDescribedShare && static_cast<double>(open) < kOpenShare * static_cast<double>(distance_.size());
  distance_ = {};
}

// A direction d = a + s b + t c of the face meets the triangle where d.(p x q) is not negative for all three edges.
// Each product is linear in s and t, and weights the opposite corner. Nothing has to be clipped.
void GlassShell::draw(const glm::vec3* corners, const glm::vec3* normals, int face) {
  const int size = planes_.faceSize();
  const glm::vec3 middle = shading::cubeDirection(face, 0.0f, 0.0f);
  const glm::vec3 alongS = shading::cubeDirection(face, 1.0f, 0.0f) - middle;
  const glm::vec3 alongT = shading::cubeDirection(face, 0.0f, 1.0f) - middle;
  glm::dvec3 edges[3];
  glm::vec2 low(1.0e30f), high(-1.0e30f);
  int behind = 0;
  for (int k = 0; k < 3; ++k) {
    edges[k] = glm::cross(glm::dvec3(corners[(k + 1) % 3]), glm::dvec3(corners[(k + 2) % 3]));
    const float depth = glm::dot(corners[k], middle);
    if (depth <= 0.0f) ++behind;
    const glm::vec2 point = glm::vec2(glm::dot(corners[k], alongS), glm::dot(corners[k], alongT)) / depth;
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  if (behind == 3) return;
  // With a corner behind the middle the projection is useless: test the whole face.
  const auto texel = [&](float x) {
    return static_cast<int>(std::floor(0.5f * (std::clamp(x, -1.0f, 1.0f) + 1.0f) * static_cast<float>(size) - 0.5f));
  };
  const int firstColumn = behind > 0 ? 0 : std::max(texel(low.x), 0);
  const int lastColumn = behind > 0 ? size - 1 : std::min(texel(high.x) + 1, size - 1);
  const int firstRow = behind > 0 ? 0 : std::max(texel(low.y), 0);
  const int lastRow = behind > 0 ? size - 1 : std::min(texel(high.y) + 1, size - 1);
  for (int row = firstRow; row <= lastRow; ++row) {
    for (int column = firstColumn; column <= lastColumn; ++column) {
      const double s = 2.0 * (column + 0.5) / size - 1.0, t = 2.0 * (row + 0.5) / size - 1.0;
      const glm::dvec3 d = glm::dvec3(middle) + s * glm::dvec3(alongS) + t * glm::dvec3(alongT);
      const double a = glm::dot(d, edges[0]), b = glm::dot(d, edges[1]), c = glm::dot(d, edges[2]);
      if (a < 0.0 || b < 0.0 || c < 0.0 || a + b + c <= 0.0) continue;
      const auto u = static_cast<float>(a / (a + b + c)), v = static_cast<float>(b / (a + b + c));
      const glm::vec3 point = u * corners[0] + v * corners[1] + (1.0f - u - v) * corners[2];
      const float distance = glm::length(point);
      const auto index =
          (static_cast<std::size_t>(face) * static_cast<std::size_t>(size) + static_cast<std::size_t>(row)) *
              static_cast<std::size_t>(size) +
          static_cast<std::size_t>(column);
      if (distance <= distance_[index]) continue;
      distance_[index] = distance;
      const glm::vec3 normal = glm::normalize(u * normals[0] + v * normals[1] + (1.0f - u - v) * normals[2]);
      planes_.setTexel(0, face, column, row, glm::vec4(normal, glm::dot(normal, point)));
    }
  }
}

}  // namespace boxprobe
