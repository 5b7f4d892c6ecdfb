#include "filters/io/cube/cube_resample.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/base/helper_threads.h"

namespace boxprobe {

namespace {

// Rows are independent, and each sample evaluates transcendental functions.
void forEachRow(int rows, const std::function<void(int row)>& work) {
  // Starting a thread costs as much as several dozen short rows.
  constexpr std::size_t kRowsWorthAThread = 48;
  std::atomic<int> next{0};
  const auto run = [&] {
    for (int row = next++; row < rows; row = next++) work(row);
  };
  const HelperThreads others(threadsFor(static_cast<std::size_t>(rows) / kRowsWorthAThread) - 1, run);
  run();
}

// The middle of sample i of n across a texel, relative to the texel's position.
double offset(int i, int n) {
  return (i + 0.5) / n - 0.5;
}

struct Line {
  int first, second;
  float share;  ///< weight of the second
};
Line clampedLine(double position, int count) {
  const double clamped = std::clamp(position, 0.0, static_cast<double>(count - 1));
  const int first = std::min(static_cast<int>(clamped), std::max(count - 2, 0));
  return {first, std::min(first + 1, count - 1), static_cast<float>(clamped - first)};
}
Line wrappedLine(double position, int count) {
  const double base = std::floor(position);
  const int first = ((static_cast<int>(base) % count) + count) % count;
  return {first, (first + 1) % count, static_cast<float>(position - base)};
}

template <typename Texel>
glm::vec4 bilinear(const Line& x, const Line& y, const Texel& texel) {
  const glm::vec4 upper = texel(x.first, y.first) * (1.0f - x.share) + texel(x.second, y.first) * x.share;
  const glm::vec4 lower = texel(x.first, y.second) * (1.0f - x.share) + texel(x.second, y.second) * x.share;
  return upper * (1.0f - y.share) + lower * y.share;
}

void store(float* rgba, const glm::vec4& value) {
  for (int c = 0; c < 4; ++c) rgba[c] = value[c];
}

}  // namespace

DirectionSampler edgeCubeSampler(const CubeMap& faces) {
  return [&faces](const glm::vec3& direction) {
    const CubePoint point = cubePoint(direction);
    const int size = faces.faceSize();
    const Line x = clampedLine(texelPosition(point.s, size, TexelPlacement::Edges), size);
    const Line y = clampedLine(texelPosition(point.t, size, TexelPlacement::Edges), size);
    return bilinear(x, y, [&](int column, int row) { return faces.texel(0, point.face, column, row); });
  };
}

DirectionSampler latLongSampler(const ImageRgbaF& picture, TexelPlacement placement) {
  return [&picture, placement](const glm::vec3& direction) {
    const glm::dvec2 point = latLongPoint(direction);
    const double column = texelPosition(point.x, picture.width, placement);
    const Line x =
        placement == TexelPlacement::Edges ? clampedLine(column, picture.width) : wrappedLine(column, picture.width);
    const Line y = clampedLine(texelPosition(point.y, picture.height, placement), picture.height);
    return bilinear(x, y, [&](int c, int r) {
      const float* p = &picture.pixels[4 * (static_cast<std::size_t>(r) * picture.width + c)];
      return glm::vec4(p[0], p[1], p[2], p[3]);
    });
  };
}

int samplesForRatio(double ratio) {
  constexpr double kEqual = 1.05;  // a face of edge texels has a longer step, by one texel's share
  constexpr double kMost = 16.0;
  return ratio <= kEqual ? 1 : static_cast<int>(std::ceil(2.0 * std::min(ratio, kMost)));
}

namespace {

/// The direction of a point of a face. Beyond an edge it continues on the next face, folded over the edge so that
/// lengths are kept: texels that share an edge then have equal footprints. The largest component is 1.
glm::vec3 foldedDirection(const CubePoint& point) {
  const float beyond = std::max(std::fabs(point.s), std::fabs(point.t)) - 1.0f;
  const glm::vec3 onFace =
      shading::cubeDirection(point.face, std::clamp(point.s, -1.0f, 1.0f), std::clamp(point.t, -1.0f, 1.0f));
  return beyond > 0.0f ? onFace - beyond * shading::cubeDirection(point.face, 0.0f, 0.0f) : onFace;
}

/// The mean over a texel of a face; `place` gives the position of the sample in column i and row j of `samples` by
/// `samples`.
template <typename Place>
glm::vec4 meanOverTexel(const DirectionSampler& source, const Place& place, int samples) {
  if (samples == 1) return source(foldedDirection(place(0, 0)));  // the value itself, bit for bit
  glm::vec4 sum(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < samples * samples; ++i) {
    const CubePoint point = place(i % samples, i / samples);
    // Three faces meet at a corner, not four: nothing lies beyond two edges at once.
    if (std::fabs(point.s) > 1.0f && std::fabs(point.t) > 1.0f) continue;
    const glm::vec3 direction = foldedDirection(point);
    const float square = glm::dot(direction, direction);
    const float weight = 1.0f / (square * std::sqrt(square));  // solid angle of a step on the face
    sum += weight * source(direction);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

CubeMap resampleToCube(const DirectionSampler& source, int faceSize, int samples) {
  CubeMap cube(faceSize, 1);
  forEachRow(6 * faceSize, [&](int line) {
    const int face = line / faceSize, row = line % faceSize;
    const auto at = [&](int texel, int sample) {
      return static_cast<float>(texelCoordinate(texel + offset(sample, samples), faceSize, TexelPlacement::Centres));
    };
    for (int column = 0; column < faceSize; ++column) {
      const auto place = [&](int i, int j) { return CubePoint{face, at(column, i), at(row, j)}; };
      cube.setTexel(0, face, column, row, meanOverTexel(source, place, samples));
    }
  });
  return cube;
}

void resampleToOpenExrFace(const DirectionSampler& source, int face, int size, int samples, float* rgba) {
  // A texel on an edge extends onto the next face, which has it too: light there must not count twice.
  const auto at = [&](int texel, int sample) {
    return static_cast<float>(
        texelCoordinate(texel + (size > 1 ? offset(sample, samples) : 0.0), size, TexelPlacement::Edges));
  };
  forEachRow(size, [&](int row) {
    for (int column = 0; column < size; ++column) {
      const auto place = [&](int i, int j) { return mirroredOpenExr({face, at(column, i), at(row, j)}); };
      store(rgba + 4 * (static_cast<std::ptrdiff_t>(row) * size + column), meanOverTexel(source, place, samples));
    }
  });
}

ImageRgbaF resampleToLatLong(const DirectionSampler& source, int width, int height, int samples) {
  ImageRgbaF picture;
  picture.width = width;
  picture.height = height;
  picture.pixels.resize(std::size_t(4) * width * height);
  forEachRow(height, [&](int row) {
    for (int column = 0; column < width; ++column) {
      glm::vec4 sum(0.0f);
      for (int i = 0; i < samples * samples; ++i) {
        const double x = texelCoordinate(column + offset(i % samples, samples), width, TexelPlacement::Edges);
        const double y = texelCoordinate(row + offset(i / samples, samples), height, TexelPlacement::Edges);
        sum += source(latLongDirection(x, std::clamp(y, -1.0, 1.0)));
      }
      store(&picture.pixels[4 * (static_cast<std::size_t>(row) * width + column)],
            sum / static_cast<float>(samples * samples));
    }
  });
  return picture;
}

}  // namespace boxprobe
