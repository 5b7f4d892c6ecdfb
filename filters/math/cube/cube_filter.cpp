#include "filters/math/cube/cube_filter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

float texelCoordinate(int index, int size) {
  return (2.0f * static_cast<float>(index) + 1.0f) / static_cast<float>(size) - 1.0f;
}

template <typename Body>
void forEachTexel(int size, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<int>(0, 6 * size), [&](const tbb::blocked_range<int>& range) {
    for (int line = range.begin(); line < range.end(); ++line) {
      const int face = line / size, row = line % size;
      for (int column = 0; column < size; ++column) body(face, column, row);
    }
  });
}

}  // namespace

int fullLevels(int faceSize) {
  int levels = 1;
  for (int size = faceSize; size > 1; size /= 2) ++levels;
  return levels;
}

void makeSourceLevels(CubeMap& source) {
  for (int level = 1; level < source.levels(); ++level) {
    const int size = source.levelSize(level);
    forEachTexel(size, [&](int face, int column, int row) {
      glm::vec4 sum(0.0f);
      float weight = 0.0f;
      for (int i = 0; i < 4; ++i) {
        const auto sizeF = static_cast<float>(size);
        const float s = shading::sourceLookup(texelCoordinate(column, size), (i & 1) == 0 ? -1.0f : 1.0f, sizeF);
        const float t = shading::sourceLookup(texelCoordinate(row, size), (i & 2) == 0 ? -1.0f : 1.0f, sizeF);
        const float w = shading::sourceWeight(s, t);
        sum += w * source.fetch(shading::cubeDirection(face, s, t), static_cast<float>(level - 1));
        weight += w;
      }
      source.setTexel(level, face, column, row, sum / weight);
    });
  }
}

void filterCubeLevel(const CubeMap& source, CubeMap& chain, int level, const std::vector<LobeTap>& taps,
                     int edgeFixupWidth) {
  const int size = chain.levelSize(level);
  const auto sizeF = static_cast<float>(size);
  const auto width = static_cast<float>(std::min(edgeFixupWidth, size / 2));
  const float last = 1.0f - 1.0f / sizeF;  // of the texels at the edge
  const auto lobeMean = [&](const glm::vec3& direction) {
    const glm::vec3 n = glm::normalize(direction);
    const glm::vec3 t = shading::lobeTangent(n), b = shading::lobeBitangent(n);
    glm::vec4 sum(0.0f);
    for (const LobeTap& tap : taps) {
      sum += tap.weight * source.fetch(tap.direction.x * t + tap.direction.y * b + tap.direction.z * n, tap.level);
    }
    return sum;
  };
  forEachTexel(size, [&](int face, int column, int row) {
    const float s = texelCoordinate(column, size), t = texelCoordinate(row, size);
    glm::vec4 value = lobeMean(shading::cubeDirection(face, s, t));
    const float shareS = shading::edgeFixupShare((last - std::abs(s)) * 0.5f * sizeF, width);
    const float shareT = shading::edgeFixupShare((last - std::abs(t)) * 0.5f * sizeF, width);
    if (shareS > 0.0f) {
      const float side = s < 0.0f ? -1.0f : 1.0f;
      value += shading::edgeFixupPull(shareS, shareT) *
               (lobeMean(shading::directionAcrossEdge(face, side, t, false, sizeF)) -
                lobeMean(shading::cubeDirection(face, side * last, t)));
    }
    if (shareT > 0.0f) {
      const float side = t < 0.0f ? -1.0f : 1.0f;
      value +=
          shading::edgeFixupPull(shareT, shareS) * (lobeMean(shading::directionAcrossEdge(face, side, s, true, sizeF)) -
                                                    lobeMean(shading::cubeDirection(face, s, side * last)));
    }
    chain.setTexel(level, face, column, row, glm::max(value, glm::vec4(0.0f)));
  });
}

CubeMap prefilterCube(const CubeMap& capture, const PrefilterSettings& settings) {
  const int faceSize = capture.faceSize();
  const auto copyLevel0 = [&](CubeMap& to) {
    const auto size = static_cast<std::size_t>(faceSize);
    for (int face = 0; face < 6; ++face) std::copy_n(capture.face(0, face), size * size * 4, to.face(0, face));
  };
  CubeMap source(faceSize, fullLevels(faceSize));
  copyLevel0(source);
  makeSourceLevels(source);
  CubeMap chain(faceSize, prefilterLevels(faceSize));
  const int fixup = settings.filter == FilterLobe::Kind::Gaussian ? settings.gaussian.edgeFixupWidth : 0;
  for (int level = 0; level < chain.levels(); ++level) {
    const FilterLobe lobe = lobeOfLevel(settings, level, chain.levels() - 1);
    if (lobe.width > 0.0f) {
      filterCubeLevel(source, chain, level, lobeTaps(lobe, samplesOfLevel(settings, level), faceSize), fixup);
    } else {
      copyLevel0(chain);
    }
  }
  return chain;
}

}  // namespace boxprobe
