// Writes a level of a cube for other programs: latitude-longitude, OpenEXR cube, cross, or six files.
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_names.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/image/exr_writer.h"

namespace boxprobe {

namespace {

/// The chosen level and its distances as functions of direction.
class Surroundings {
 public:
  Surroundings(const CubeMap& cube, const CubePictureOptions& options)
      : cube_(cube), distance_(options.distance), level_(options.level), size_(cube.levelSize(options.level)) {}

  int size() const { return size_; }
  bool hasDistance() const { return distance_ != nullptr && !distance_->empty(); }
  glm::vec4 texel(int face, int column, int row) const { return cube_.texel(level_, face, column, row); }
  DirectionSampler color() const {
    return [this](const glm::vec3& direction) { return cube_.fetch(direction, static_cast<float>(level_)); };
  }
  /// Not interpolated: between a near and a far surface there is nothing.
  DirectionSampler distance() const {
    return [this](const glm::vec3& direction) {
      const CubePoint point = cubePoint(direction);
      const int last = distance_->faceSize() - 1;
      const auto index = [&](float x) {
        return std::clamp(static_cast<int>((0.5f * x + 0.5f) * static_cast<float>(last + 1)), 0, last);
      };
      return distance_->texel(0, point.face, index(point.s), index(point.t));
    };
  }

 private:
  const CubeMap& cube_;
  const CubeMap* distance_;
  int level_, size_;
};

ExrPart finish(ExrPart part, const float* rgba, const std::vector<float>& distance, ExrPrecision precision) {
  ExrLevel& level = part.levels.front();
  addRgba(level, rgba, precision);
  if (!distance.empty()) addPlane(level, "distance", distance.data(), 4, ExrPrecision::Float);
  part.header.compression() = chooseCompression(level);
  return part;
}

ExrPart latLongPart(const Surroundings& source, int faceSize, ExrPrecision precision) {
  const int width = 4 * faceSize, height = 2 * faceSize;
  // Seen from the middle, the cube's texels are densest at the edges of faces: N per radian.
  constexpr double kPi = 3.14159265358979323846;
  const int samples = samplesForRatio(source.size() / (width / (2.0 * kPi)));
  const ImageRgbaF picture = resampleToLatLong(source.color(), width, height, samples);
  std::vector<float> distance;
  if (source.hasDistance()) distance = resampleToLatLong(source.distance(), width, height, 1).pixels;
  ExrPart part = exrPart(width, height);
  Imf::addEnvmap(part.header, Imf::ENVMAP_LATLONG);
  return finish(std::move(part), picture.pixels.data(), distance, precision);
}

/// Faces below each other, in OpenEXR's convention.
std::vector<float> openExrFaces(const DirectionSampler& source, int faceSize, int samples) {
  const std::size_t values = std::size_t(4) * faceSize * faceSize;
  std::vector<float> pixels(6 * values);
  for (int face = 0; face < 6; ++face) {
    resampleToOpenExrFace(source, face, faceSize, samples, &pixels[static_cast<std::size_t>(face) * values]);
  }
  return pixels;
}

ExrPart openExrCubePart(const Surroundings& source, int faceSize, ExrPrecision precision) {
  const int samples = samplesForRatio(static_cast<double>(source.size()) / faceSize);
  std::vector<float> distance;
  if (source.hasDistance()) distance = openExrFaces(source.distance(), faceSize, 1);
  ExrPart part = exrPart(faceSize, 6 * faceSize);
  Imf::addEnvmap(part.header, Imf::ENVMAP_CUBE);
  return finish(std::move(part), openExrFaces(source.color(), faceSize, samples).data(), distance, precision);
}

/// OpenGL's faces: a copy if the size is the level's, else resampled.
CubeMap openGlFaces(const Surroundings& source, int faceSize) {
  if (faceSize != source.size()) {
    return resampleToCube(source.color(), faceSize, samplesForRatio(static_cast<double>(source.size()) / faceSize));
  }
  CubeMap faces(faceSize, 1);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < faceSize * faceSize; ++i) {
      faces.setTexel(0, face, i % faceSize, i / faceSize, source.texel(face, i % faceSize, i / faceSize));
    }
  }
  return faces;
}

void copyFace(const CubeMap& faces, int face, int left, int top, int width, std::vector<float>& pixels) {
  const int size = faces.faceSize();
  for (int row = 0; row < size; ++row) {
    const float* from = faces.face(0, face) + std::ptrdiff_t(4) * row * size;
    std::copy_n(from, 4 * size, pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(top + row) * width + left));
  }
}

ExrPart crossPart(const Surroundings& source, int faceSize, ExrPrecision precision) {
  const int width = 4 * faceSize, height = 3 * faceSize;
  const auto unfold = [&](const CubeMap& faces) {
    std::vector<float> pixels(std::size_t(4) * width * height, 0.0f);
    for (int face = 0; face < 6; ++face) {
      const FaceCell cell = kCrossWide[static_cast<std::size_t>(face)];
      copyFace(faces, face, cell.column * faceSize, cell.row * faceSize, width, pixels);
    }
    return pixels;
  };
  std::vector<float> distance;
  if (source.hasDistance()) distance = unfold(resampleToCube(source.distance(), faceSize, 1));
  return finish(exrPart(width, height), unfold(openGlFaces(source, faceSize)).data(), distance, precision);
}

void saveSixFiles(const std::string& pattern, const Surroundings& source, int faceSize, ExrPrecision precision) {
  const SixNames names = sixNamesToWrite(pattern);
  const std::size_t values = std::size_t(4) * faceSize * faceSize;
  std::vector<float> color, distance;
  if (names.openExr) {
    color = openExrFaces(source.color(), faceSize, samplesForRatio(static_cast<double>(source.size()) / faceSize));
    if (source.hasDistance()) distance = openExrFaces(source.distance(), faceSize, 1);
  } else {
    const CubeMap faces = openGlFaces(source, faceSize);
    color.assign(faces.face(0, 0), faces.face(0, 0) + 6 * values);
    if (source.hasDistance()) {
      const CubeMap distances = resampleToCube(source.distance(), faceSize, 1);
      distance.assign(distances.face(0, 0), distances.face(0, 0) + 6 * values);
    }
  }
  for (std::size_t face = 0; face < 6; ++face) {
    const auto start = static_cast<std::ptrdiff_t>(face * values), end = start + static_cast<std::ptrdiff_t>(values);
    std::vector<float> own;
    if (!distance.empty()) own.assign(distance.begin() + start, distance.begin() + end);
    saveExrParts(names.paths[face], {finish(exrPart(faceSize, faceSize), &color[face * values], own, precision)});
  }
}

}  // namespace

void saveCubePicture(const std::string& path, const CubeMap& cube, CubeLayout layout,
                     const CubePictureOptions& options) {
  if (options.level < 0 || options.level >= cube.levels()) {
    throw InputError(path + ": level " + std::to_string(options.level) + " was asked for; the cube has " +
                     std::to_string(cube.levels()) + " levels, counted from 0");
  }
  if (options.faceSize < 0 || options.faceSize > limits::kCubeFace) {
    throw InputError(path + ": faces of " + std::to_string(options.faceSize) + " texels were asked for; use 1 to " +
                     std::to_string(limits::kCubeFace));
  }
  const Surroundings source(cube, options);
  const int faceSize = options.faceSize > 0 ? options.faceSize : source.size();
  switch (layout) {
    case CubeLayout::LatLong:
      return saveExrParts(path, {latLongPart(source, faceSize, options.precision)});
    case CubeLayout::Automatic:
    case CubeLayout::Strip:
      return saveExrParts(path, {openExrCubePart(source, faceSize, options.precision)});
    case CubeLayout::Cross:
      return saveExrParts(path, {crossPart(source, faceSize, options.precision)});
    case CubeLayout::SixFiles:
      return saveSixFiles(path, source, faceSize, options.precision);
  }
}

}  // namespace boxprobe
