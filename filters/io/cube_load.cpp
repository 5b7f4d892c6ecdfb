// Any environment picture as a cube: which layout it has, then its faces copied where they are OpenGL's texels, or
// resampled where the directions differ.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>

#include "filters/core/errors.h"
#include "filters/io/cube_file.h"
#include "filters/io/cube_names.h"
#include "filters/io/cube_resample.h"
#include "filters/io/exr_reader.h"
#include "filters/io/image_detail.h"
#include "filters/io/image_file.h"

namespace boxprobe {

namespace {

constexpr int kLargestFace = 4096;
constexpr int kLargestAutomaticFace = 2048, kSmallestAutomaticFace = 16;  // what a probe may have

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

/// A picture with what was wrong with its values put right.
struct Source {
  std::string path;
  ExrPicture picture;
  std::size_t texelsNotFinite = 0;
  std::size_t texelsClamped = 0;
};

void cleanTexels(Source& source) {
  constexpr float kHalfMax = 65504.0f;
  std::vector<float>& pixels = source.picture.image.pixels;
  for (std::size_t texel = 0; texel < pixels.size(); texel += 4) {
    bool finite = true, inRange = true;
    for (std::size_t c = texel; c < texel + 4; ++c) {
      if (!std::isfinite(pixels[c])) {
        finite = false;
        pixels[c] = 0.0f;
      } else if (std::fabs(pixels[c]) > kHalfMax) {
        inRange = false;
        pixels[c] = std::copysign(kHalfMax, pixels[c]);
      }
    }
    source.texelsNotFinite += finite ? 0 : 1;
    source.texelsClamped += inRange ? 0 : 1;
  }
  for (float& distance : source.picture.distance) {
    if (!std::isfinite(distance) || distance < 0.0f) distance = 0.0f;
  }
}

Source readSource(const std::string& path) {
  Source source;
  source.path = path;
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".exr") {
    withExrFile(path, [&](Imf::MultiPartInputFile& file) {
      source.picture = readExrPart(file, picturePart(file, path), path);
    });
  } else {
    source.picture.image = loadHdrImage(path, &source.texelsNotFinite);
    source.picture.displayWidth = source.picture.image.width;
    source.picture.displayHeight = source.picture.image.height;
  }
  cleanTexels(source);
  return source;
}

CubeLayout layoutOfShape(long long width, long long height) {
  if (width == 2 * height) return CubeLayout::LatLong;
  if (width == 6 * height || height == 6 * width) return CubeLayout::Strip;
  if (3 * width == 4 * height && width % 4 == 0) return CubeLayout::Cross;
  if (4 * width == 3 * height && width % 3 == 0) return CubeLayout::Cross;
  return CubeLayout::Automatic;
}

/// The pixels of the display window: a writer may have left out what is black, or have rendered more than is shown.
void fillDisplayWindow(ExrPicture& picture) {
  ImageRgbaF whole;
  whole.width = picture.displayWidth;
  whole.height = picture.displayHeight;
  whole.pixels.assign(std::size_t(4) * whole.width * whole.height, 0.0f);
  std::vector<float> distance(picture.distance.empty() ? 0 : whole.pixels.size() / 4, 0.0f);
  const ImageRgbaF& part = picture.image;
  const int left = std::max(0, -picture.offsetX), right = std::min(part.width, whole.width - picture.offsetX);
  for (int row = 0; row < part.height && left < right; ++row) {
    const int target = row + picture.offsetY;
    if (target < 0 || target >= whole.height) continue;
    const auto from = static_cast<std::ptrdiff_t>(row) * part.width + left;
    const auto to = static_cast<std::ptrdiff_t>(target) * whole.width + left + picture.offsetX;
    std::copy_n(part.pixels.begin() + 4 * from, 4 * (right - left), whole.pixels.begin() + 4 * to);
    if (!distance.empty()) std::copy_n(picture.distance.begin() + from, right - left, distance.begin() + to);
  }
  picture.image = std::move(whole);
  picture.distance = std::move(distance);
  picture.offsetX = picture.offsetY = 0;
}

CubeLayout detectLayout(Source& source) {
  ExrPicture& picture = source.picture;
  if (picture.envmap) return *picture.envmap == EnvmapKind::LatLong ? CubeLayout::LatLong : CubeLayout::Strip;
  const CubeLayout byData = layoutOfShape(picture.image.width, picture.image.height);
  if (byData != CubeLayout::Automatic) return byData;
  const CubeLayout byDisplay = layoutOfShape(picture.displayWidth, picture.displayHeight);
  if (byDisplay != CubeLayout::Automatic) {
    checkImageSize(source.path, picture.displayWidth, picture.displayHeight);
    fillDisplayWindow(picture);
  }
  return byDisplay;
}

/// A picture's value at a pixel: its colour, or its distance in red.
using PixelReader = std::function<glm::vec4(const Source&, int column, int row)>;
glm::vec4 colorAt(const Source& source, int column, int row) {
  const ImageRgbaF& image = source.picture.image;
  const float* p = &image.pixels[4 * (static_cast<std::size_t>(row) * image.width + column)];
  return {p[0], p[1], p[2], p[3]};
}
glm::vec4 distanceAt(const Source& source, int column, int row) {
  return {source.picture.distance[static_cast<std::size_t>(row) * source.picture.image.width + column], 0.0f, 0.0f,
          0.0f};
}

/// Where a face lies in a picture of several, in units of faces.
struct Cell {
  int column, row;
  bool turned = false;  ///< by half a turn
};
using Cells = std::array<Cell, 6>;
constexpr Cells kRow = {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}};
constexpr Cells kColumn = {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}};
// Unfolded around +Z, neighbours meeting as they do on the cube.
constexpr Cells kCrossWide = {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
constexpr Cells kCrossTall = {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}};

/// Six faces in OpenGL's orientation, texels where the picture has them.
struct Faces {
  std::array<const Source*, 6> sources{};
  Cells cells{};
  int size = 0;
  bool openExr = false;

  CubeMap copy(const PixelReader& read) const {
    CubeMap cube(size, 1);
    for (int face = 0; face < 6; ++face) {
      const Cell cell = cells[static_cast<std::size_t>(face)];
      const bool vertical = face == 2 || face == 3;
      const bool flipColumns = openExr ? !vertical : cell.turned, flipRows = openExr ? vertical : cell.turned;
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const int x = flipColumns ? size - 1 - column : column, y = flipRows ? size - 1 - row : row;
          cube.setTexel(0, face, column, row,
                        read(*sources[static_cast<std::size_t>(face)], cell.column * size + x, cell.row * size + y));
        }
      }
    }
    return cube;
  }
};

int nearestFaceSize(double texels) {
  const int power = static_cast<int>(std::lround(std::log2(std::max(texels, 1.0))));
  return std::clamp(1 << std::min(power, 20), kSmallestAutomaticFace, kLargestAutomaticFace);
}

/// Distances are not averaged: half way between a near and a far surface there is neither.
CubeMap nearestToCube(const std::function<glm::vec4(const glm::vec3&)>& nearest, int faceSize) {
  return resampleToCube(nearest, faceSize, 1);
}

int nearestIndex(double coordinate, int count, TexelPlacement placement) {
  return std::clamp(static_cast<int>(std::lround(texelPosition(coordinate, count, placement))), 0, count - 1);
}

void convertFaces(const Faces& faces, int faceSize, LoadedCube& result) {
  const TexelPlacement placement = faces.openExr ? TexelPlacement::Edges : TexelPlacement::Centres;
  if (faceSize == 0) faceSize = nearestFaceSize(faces.size);
  const bool asIs = !faces.openExr && faceSize == faces.size;
  CubeMap radiance = faces.copy(colorAt);
  if (!asIs) {
    const DirectionSampler source =
        faces.openExr ? edgeCubeSampler(radiance)
                      : [&radiance](const glm::vec3& direction) { return radiance.fetch(direction, 0.0f); };
    result.radiance = resampleToCube(source, faceSize, samplesForRatio(static_cast<double>(faces.size) / faceSize));
  } else {
    result.radiance = std::move(radiance);
  }
  const bool distances = std::all_of(faces.sources.begin(), faces.sources.end(),
                                     [](const Source* source) { return !source->picture.distance.empty(); });
  if (!distances) return;
  CubeMap distance = faces.copy(distanceAt);
  if (!asIs) {
    const auto nearest = [&](const glm::vec3& direction) {
      const CubePoint point = cubePoint(direction);
      return distance.texel(0, point.face, nearestIndex(point.s, faces.size, placement),
                            nearestIndex(point.t, faces.size, placement));
    };
    result.distance = nearestToCube(nearest, faceSize);
  } else {
    result.distance = std::move(distance);
  }
}

void convertLatLong(const Source& source, int faceSize, LoadedCube& result) {
  const ImageRgbaF& image = source.picture.image;
  if (std::abs(image.width - 2 * image.height) > 2) {
    throw InputError(source.path + ": is " + sizeText(image.width, image.height) +
                     "; a latitude-longitude map is twice as wide as high");
  }
  // As many texels over the sphere: 6 N² = W²/2.
  if (faceSize == 0) faceSize = nearestFaceSize(image.width / std::sqrt(12.0));
  // Only a file that says so has OpenEXR's texels on the edges; every other one has them at the centres of its cells.
  const TexelPlacement placement = source.picture.envmap ? TexelPlacement::Edges : TexelPlacement::Centres;
  constexpr double kPi = 3.14159265358979323846;
  const double ratio = image.width / (kPi * faceSize);  // texels of the picture a texel in the middle of a face
  result.radiance = resampleToCube(latLongSampler(image, placement), faceSize, samplesForRatio(ratio));
  if (source.picture.distance.empty()) return;
  const auto nearest = [&](const glm::vec3& direction) {
    const glm::dvec2 point = latLongPoint(direction);
    return distanceAt(source, nearestIndex(point.x, image.width, placement),
                      nearestIndex(point.y, image.height, placement));
  };
  result.distance = nearestToCube(nearest, faceSize);
}

void convertPicture(const Source& source, CubeLayout layout, int faceSize, LoadedCube& result) {
  if (layout == CubeLayout::LatLong) return convertLatLong(source, faceSize, result);
  const ImageRgbaF& image = source.picture.image;
  Faces faces;
  faces.sources.fill(&source);
  faces.openExr = layout == CubeLayout::Strip && source.picture.envmap == EnvmapKind::Cube;
  const bool wide = image.width > image.height;
  if (layout == CubeLayout::Strip) {
    faces.cells = wide ? kRow : kColumn;
    faces.size = std::min(image.width, image.height);
    const bool fits =
        faces.openExr ? image.height == 6 * image.width : std::max(image.width, image.height) == 6 * faces.size;
    if (!fits) {
      throw InputError(source.path + ": is " + sizeText(image.width, image.height) +
                       (faces.openExr ? "; attribute envmap says cube, which is six times as high as wide"
                                      : "; a strip of six faces is six times as long as wide"));
    }
  } else {
    faces.cells = wide ? kCrossWide : kCrossTall;
    faces.size = wide ? image.width / 4 : image.width / 3;
    if (layoutOfShape(image.width, image.height) != CubeLayout::Cross) {
      throw InputError(source.path + ": is " + sizeText(image.width, image.height) +
                       "; a cross of faces is 4:3 or 3:4 and a whole number of faces wide");
    }
  }
  convertFaces(faces, faceSize, result);
}

LoadedCube loadSixFiles(const std::string& path, int faceSize) {
  const auto names = findSixNames(path);
  if (!names) {
    throw InputError(path +
                     ": the six files of a cube were not found; name them NAME_px, NAME_nx, NAME_py, NAME_ny, "
                     "NAME_pz and NAME_nz, or use a 2:1 latitude-longitude map, a 6:1 strip or a 4:3 cross");
  }
  std::array<Source, 6> sources;
  LoadedCube result;
  result.layout = CubeLayout::SixFiles;
  Faces faces;
  faces.openExr = names->openExr;
  for (std::size_t i = 0; i < 6; ++i) {
    sources[i] = readSource(names->paths[i]);
    const ImageRgbaF& image = sources[i].picture.image;
    if (image.width != image.height) {
      throw InputError(names->paths[i] + ": is " + sizeText(image.width, image.height) + "; a face must be square");
    }
    if (i == 0) faces.size = image.width;
    if (image.width != faces.size) {
      throw InputError(names->paths[i] + ": is " + sizeText(image.width, image.height) + " and " + names->paths[0] +
                       " is " + sizeText(faces.size, faces.size) + "; the six faces must be equal in size");
    }
    faces.sources[i] = &sources[i];
    result.texelsNotFinite += sources[i].texelsNotFinite;
    result.texelsClamped += sources[i].texelsClamped;
  }
  convertFaces(faces, faceSize, result);
  return result;
}

}  // namespace

LoadedCube loadCube(const std::string& path, CubeLayout layout, int faceSize) {
  if (faceSize < 0 || faceSize > kLargestFace || (faceSize & (faceSize - 1)) != 0) {
    throw InputError(path + ": a face size of " + std::to_string(faceSize) +
                     " was asked for; use a power of two up to " + std::to_string(kLargestFace));
  }
  std::error_code ignored;
  const bool pattern = path.find('%') != std::string::npos && !std::filesystem::exists(path, ignored);
  if (layout == CubeLayout::SixFiles || pattern) return loadSixFiles(path, faceSize);
  Source source = readSource(path);
  if (layout == CubeLayout::Automatic) layout = detectLayout(source);
  const ImageRgbaF& image = source.picture.image;
  if (layout == CubeLayout::Automatic) {
    if (image.width == image.height) return loadSixFiles(path, faceSize);
    throw InputError(path + ": is " + sizeText(image.width, image.height) +
                     ", which is no layout of a cube; use a 2:1 latitude-longitude map, a 6:1 or 1:6 strip, a 4:3 or "
                     "3:4 cross, or six square files");
  }
  LoadedCube result;
  result.layout = layout;
  result.texelsNotFinite = source.texelsNotFinite;
  result.texelsClamped = source.texelsClamped;
  convertPicture(source, layout, faceSize, result);
  return result;
}

}  // namespace boxprobe
