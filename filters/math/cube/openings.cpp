#include "filters/math/cube/openings.h"

#include <algorithm>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

CubeMap reducedCube(const CubeMap& cube, int most) {
  const int size = std::min(cube.faceSize(), most), step = cube.faceSize() / size;
  CubeMap reduced(size, 1);
  const float share = 1.0f / static_cast<float>(step * step);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        glm::vec4 sum(0.0f);
        for (int k = 0; k < step * step; ++k)
          sum += cube.texel(0, face, column * step + k % step, row * step + k / step);
        reduced.setTexel(0, face, column, row, share * sum);
      }
    }
  }
  return reduced;
}

bool anyOpening(const CubeMap& coverage) {
  for (int face = 0; face < 6; ++face) {
    const float* texels = coverage.face(0, face);
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(coverage.faceSize()) * coverage.faceSize();
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      if (texels[4 * i + 3] < 1.0f) return true;
    }
  }
  return false;
}

ShCoefficients skyThroughOpenings(const CubeMap& coverage, const glm::dmat3& worldFromMap, const CubeMap& sky) {
  const int size = coverage.faceSize();
  const glm::mat3 turn(worldFromMap);
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) {
    std::vector<float>& texels = faces[static_cast<std::size_t>(face)];
    texels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto place = [size](int i) {
          return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f;
        };
        const float open = 1.0f - coverage.texel(0, face, column, row).a;
        const glm::vec4 light =
            open > 0.0f ? open * sky.fetch(turn * shading::cubeDirection(face, place(column), place(row)), 0.0f)
                        : glm::vec4(0.0f);
        texels.insert(texels.end(), {light.r, light.g, light.b, open});
      }
    }
  }
  return irradianceCoefficients(faces, size, worldFromMap);
}

CubeMap throughChain(const CubeMap& coverage, const CubeMap* tint, bool openIfWhole) {
  const int size = coverage.faceSize();
  CubeMap chain(size, fullLevels(size));
  const bool open = openIfWhole && !anyOpening(coverage);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < size * size; ++i) {
      const int column = i % size, row = i / size;
      const float through = open ? 1.0f : std::clamp(1.0f - coverage.texel(0, face, column, row).a, 0.0f, 1.0f);
      const glm::vec3 color = tint != nullptr ? glm::vec3(tint->texel(0, face, column, row)) : glm::vec3(1.0f);
      chain.setTexel(0, face, column, row, glm::vec4(through * color, 1.0f));
    }
  }
  makeSourceLevels(chain);
  return chain;
}

}  // namespace boxprobe
