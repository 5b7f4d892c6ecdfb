#include "filters/math/cube/spherical_harmonics.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

namespace {

// Real spherical harmonics are a constant times a polynomial; the constant enters twice, in the projection and in the
// evaluation, so its square is folded into the coefficient.
constexpr double kConstant[9] = {0.282094791773878, 0.488602511902920, 0.488602511902920,
                                 0.488602511902920, 1.092548430592079, 1.092548430592079,
                                 0.315391565252520, 1.092548430592079, 0.546274215296040};

std::array<double, 9> polynomials(const glm::dvec3& n) {
  return {1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0, n.x * n.z, n.x * n.x - n.y * n.y};
}

// Clamped cosine over pi, by band.
constexpr double kCosine[9] = {1.0, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};

}  // namespace

ShCoefficients irradianceCoefficients(const std::array<std::vector<float>, 6>& faces, int faceSize,
                                      const glm::dmat3& worldFromMap) {
  std::array<glm::dvec3, 9> sum{};
  const double step = 2.0 / faceSize;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        const double s0 = -1.0 + column * step, t0 = -1.0 + row * step;
        const double solidAngle = cubeSolidAngle(s0, t0, s0 + step, t0 + step);
        const glm::dvec3 direction = glm::normalize(glm::dvec3(
            shading::cubeDirection(face, static_cast<float>(s0 + 0.5 * step), static_cast<float>(t0 + 0.5 * step))));
        const float* texel =
            &faces[static_cast<std::size_t>(face)][static_cast<std::size_t>(row * faceSize + column) * 4];
        const glm::dvec3 radiance(texel[0], texel[1], texel[2]);
        const auto y = polynomials(worldFromMap * direction);
        for (std::size_t i = 0; i < 9; ++i) sum[i] += radiance * (y[i] * solidAngle);
      }
    }
  }
  ShCoefficients result;
  for (std::size_t i = 0; i < 9; ++i) result[i] = glm::vec3(sum[i] * (kCosine[i] * kConstant[i] * kConstant[i]));
  return result;
}

}  // namespace boxprobe
