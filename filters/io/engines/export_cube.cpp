#include "filters/io/engines/export_cube.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

namespace {

float exportCoordinate(int index, int size) {
  return (2.0f * static_cast<float>(index) + 1.0f) / static_cast<float>(size) - 1.0f;
}

/// Sets every texel of a level to `value(direction)`; the direction goes through the texel's centre and is not unit.
template <typename Value>
void fillLevel(CubeMap& cube, int level, const Value& value) {
  const int size = cube.levelSize(level);
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        cube.setTexel(level, face, column, row,
                      value(shading::cubeDirection(face, exportCoordinate(column, size), exportCoordinate(row, size))));
      }
    }
  }
}

void copyLevel(const CubeMap& from, int level, CubeMap& to, int toLevel) {
  const auto size = static_cast<std::size_t>(from.levelSize(level));
  for (int face = 0; face < 6; ++face) std::copy_n(from.face(level, face), size * size * 4, to.face(toLevel, face));
}

/// All levels down to one texel, made from level 0.
CubeMap sourceLevels(const CubeMap& level0) {
  CubeMap source(level0.faceSize(), fullLevels(level0.faceSize()));
  copyLevel(level0, 0, source, 0);
  makeSourceLevels(source);
  return source;
}

}  // namespace

CubeMap resizedCube(const CubeMap& cube, int faceSize) {
  CubeMap resized(faceSize, 1);
  int level = 0;
  for (int size = cube.faceSize(); size > faceSize; size /= 2) ++level;
  copyLevel(level == 0 ? cube : sourceLevels(cube), level, resized, 0);
  return resized;
}

CubeMap rotatedCube(const CubeMap& cube, const glm::mat3& cubeFromTurned) {
  CubeMap rotated(cube.faceSize(), 1);
  fillLevel(rotated, 0, [&](const glm::vec3& direction) { return cube.fetch(cubeFromTurned * direction, 0.0f); });
  return rotated;
}

CubeMap recentredCube(const CubeMap& cube, const glm::vec3& boxMin, const glm::vec3& boxMax, const glm::vec3& centre) {
  CubeMap moved(cube.faceSize(), 1);
  fillLevel(moved, 0, [&](const glm::vec3& direction) {
    const glm::vec3 factors = shading::slabFactors(centre, direction, boxMin, boxMax);
    const float t = std::min({factors.x, factors.y, factors.z});
    return cube.fetch(shading::lookupDirection(centre + t * direction), 0.0f);
  });
  return moved;
}

CubeMap ladderChain(const CubeMap& level0, const LadderRow& ladder, int samples) {
  const int faceSize = level0.faceSize(), levels = ladder.levels(faceSize);
  const CubeMap source = sourceLevels(level0);
  CubeMap chain(faceSize, levels);
  PrefilterSettings settings;
  settings.samples = samples;
  for (int level = 0; level < levels; ++level) {
    const double roughness = ladder.roughness(level, levels, faceSize);
    if (roughness <= 0.0) {
      copyLevel(source, level, chain, level);
      continue;
    }
    const FilterLobe lobe = {FilterLobe::Kind::Ggx, static_cast<float>(roughness * roughness)};
    filterCubeLevel(source, chain, level, lobeTaps(lobe, samplesOfLevel(settings, level), faceSize));
  }
  return chain;
}

CubeMap turnedCube(const CubeMap& cube, const glm::vec3& lookup) {
  CubeMap turned(cube.faceSize(), cube.levels());
  for (int level = 0; level < cube.levels(); ++level) {
    const auto last = cube.levelSize(level) - 1;
    const auto size = static_cast<float>(cube.levelSize(level));
    fillLevel(turned, level, [&](const glm::vec3& direction) {
      const CubePoint point = cubePoint(direction * lookup);  // an involution
      const auto texel = [&](float s) { return std::clamp(static_cast<int>((0.5f * s + 0.5f) * size), 0, last); };
      return cube.texel(level, point.face, texel(point.s), texel(point.t));
    });
  }
  return turned;
}

CubeMap diffuseCube(const ShCoefficients& c, const glm::mat3& worldFromCube, int faceSize) {
  CubeMap cube(faceSize, 1);
  fillLevel(cube, 0, [&](const glm::vec3& direction) {
    const glm::vec3 normal = worldFromCube * glm::normalize(direction);
    return glm::vec4(shading::shIrradiance(normal, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]), 1.0f);
  });
  return cube;
}

ImageRgbaF latLongPicture(const CubeMap& cube, const glm::vec3& centre) {
  constexpr double kPi = 3.14159265358979324;
  ImageRgbaF picture;
  picture.width = 4 * cube.faceSize();
  picture.height = 2 * cube.faceSize();
  picture.pixels.resize(std::size_t(4) * picture.width * picture.height);
  const glm::dvec3 ahead(centre), up(0.0, 1.0, 0.0), right = glm::cross(ahead, up);
  float* pixel = picture.pixels.data();
  for (int row = 0; row < picture.height; ++row) {
    const double elevation = kPi * (0.5 - (row + 0.5) / picture.height);
    for (int column = 0; column < picture.width; ++column, pixel += 4) {
      const double turn = 2.0 * kPi * ((column + 0.5) / picture.width - 0.5);
      const glm::dvec3 direction =
          std::cos(elevation) * (std::cos(turn) * ahead + std::sin(turn) * right) + std::sin(elevation) * up;
      const glm::vec4 value = cube.fetch(glm::vec3(direction), 0.0f);
      for (int channel = 0; channel < 4; ++channel) pixel[channel] = value[channel];
    }
  }
  return picture;
}

}  // namespace boxprobe
