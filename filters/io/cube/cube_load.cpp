// Reads any environment picture as a cube: copies faces whose texels match OpenGL's, and resamples others.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/matrix.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_names.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/cube/cube_source.h"
#include "filters/io/cube/picture_repair.h"

namespace boxprobe {

namespace {

constexpr int kLargestAutomaticFace = 2048, kSmallestAutomaticFace = 16;  // limits of a probe's face size

/// The last step of every way: what is beyond half floats.
using Finish = std::function<void(LoadedCube&)>;

/// A picture's value at a pixel: its colour, or its distance in the red channel.
using PixelReader = std::function<glm::vec4(const CubeSource&, int column, int row)>;
glm::vec4 colorAt(const CubeSource& source, int column, int row) {
  const ImageRgbaF& image = source.picture.image;
  const float* p = &image.pixels[4 * (static_cast<std::size_t>(row) * image.width + column)];
  return {p[0], p[1], p[2], p[3]};
}
glm::vec4 distanceAt(const CubeSource& source, int column, int row) {
  return {source.picture.distance[static_cast<std::size_t>(row) * source.picture.image.width + column], 0.0f, 0.0f,
          0.0f};
}

/// Six faces in OpenGL's orientation, with the picture's placement of texels.
struct Faces {
  std::array<const CubeSource*, 6> sources{};
  FaceCells cells{};
  int size = 0;
  bool openExr = false;
  bool inside = false;  ///< +X and -X are exchanged, every face is mirrored

  CubeMap copy(const PixelReader& read) const {
    CubeMap cube(size, 1);
    for (int face = 0; face < 6; ++face) {
      const auto from = static_cast<std::size_t>(inside && face < 2 ? 1 - face : face);
      const FaceCell cell = cells[from];
      const bool vertical = face == 2 || face == 3;
      const bool flipColumns = openExr ? !vertical : cell.turned != inside, flipRows = openExr ? vertical : cell.turned;
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const int x = flipColumns ? size - 1 - column : column, y = flipRows ? size - 1 - row : row;
          cube.setTexel(0, face, column, row, read(*sources[from], cell.column * size + x, cell.row * size + y));
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

/// Distances are not interpolated: between a near and a far surface there is nothing.
CubeMap nearestToCube(const std::function<glm::vec4(const glm::vec3&)>& nearest, int faceSize) {
  return resampleToCube(nearest, faceSize, 1);
}

int nearestIndex(double coordinate, int count, TexelPlacement placement) {
  return std::clamp(static_cast<int>(std::lround(texelPosition(coordinate, count, placement))), 0, count - 1);
}

/// Faces in OpenGL's layout, or with their texels on the edges.
void convertCube(CubeMap radiance, CubeMap distance, TexelPlacement placement, int faceSize, LoadedCube& result) {
  const int size = radiance.faceSize();
  if (faceSize == 0) faceSize = nearestFaceSize(size);
  if (placement == TexelPlacement::Centres && faceSize == size && (distance.empty() || distance.faceSize() == size)) {
    result.radiance = std::move(radiance);
    result.distance = std::move(distance);
    return;
  }
  const DirectionSampler source = placement == TexelPlacement::Edges
                                      ? edgeCubeSampler(radiance)
                                      : [&](const glm::vec3& direction) { return radiance.fetch(direction, 0.0f); };
  result.radiance = resampleToCube(source, faceSize, samplesForRatio(static_cast<double>(size) / faceSize));
  if (distance.empty()) return;
  const auto nearest = [&](const glm::vec3& direction) {
    const CubePoint point = cubePoint(direction);
    const int side = distance.faceSize();
    return distance.texel(0, point.face, nearestIndex(point.s, side, placement),
                          nearestIndex(point.t, side, placement));
  };
  result.distance = nearestToCube(nearest, faceSize);
}

void convertFaces(const Faces& faces, int faceSize, LoadedCube& result) {
  const bool distances = std::all_of(faces.sources.begin(), faces.sources.end(),
                                     [](const CubeSource* source) { return !source->picture.distance.empty(); });
  convertCube(faces.copy(colorAt), distances ? faces.copy(distanceAt) : CubeMap(),
              faces.openExr ? TexelPlacement::Edges : TexelPlacement::Centres, faceSize, result);
}

/// Both maps sampled in other directions; distances, between which there is nothing, without interpolation.
void turnMaps(CubeMap& radiance, CubeMap& distance, const glm::mat3& mapFromWorld) {
  const CubeMap turned = std::move(radiance), seen = std::move(distance);
  radiance = resampleToCube([&](const glm::vec3& d) { return turned.fetch(mapFromWorld * d, 0.0f); }, turned.faceSize(),
                            samplesForRatio(1.0));
  distance = CubeMap();
  if (seen.empty()) return;
  const auto nearest = [&](const glm::vec3& d) {
    const CubePoint point = cubePoint(mapFromWorld * d);
    const int side = seen.faceSize();
    return seen.texel(0, point.face, nearestIndex(point.s, side, TexelPlacement::Centres),
                      nearestIndex(point.t, side, TexelPlacement::Centres));
  };
  distance = nearestToCube(nearest, seen.faceSize());
}

LoadedCube fromBaked(BakedProbeFile file, int faceSize, const Finish& finish) {
  CubeMap finest(file.maps.radiance.faceSize(), 1);
  LoadedCube result;
  result.layout = CubeLayout::Strip;
  result.repairs.notFinite = file.texelsNotFinite;
  const int count = 6 * finest.faceSize() * finest.faceSize();
  for (int texel = 0; texel < count; ++texel) {
    const float* from = file.maps.radiance.face(0, 0) + std::ptrdiff_t(4) * texel;
    float* to = finest.face(0, 0) + std::ptrdiff_t(4) * texel;
    std::transform(from, from + 4, to, [](float v) { return std::clamp(v, -kHalfMax, kMostRadiance); });
    if (*std::max_element(to, to + 3) > kHalfMax) ++result.repairs.beyondHalf;  // from a float file: halves do not
  }
  CubeMap distance = std::move(file.maps.distance);
  if (file.maps.capturedRotation != glm::dvec3(0.0)) {
    // As other programs read it: along the world's axes.
    turnMaps(finest, distance, glm::mat3(glm::transpose(rotationMatrix(file.maps.capturedRotation))));
  }
  convertCube(std::move(finest), std::move(distance), TexelPlacement::Centres, faceSize, result);
  finish(result);
  return result;
}

void convertLatLong(const CubeSource& source, int faceSize, LoadedCube& result) {
  const ImageRgbaF& image = source.picture.image;
  if (std::abs(image.width - 2 * image.height) > 2) {
    throw InputError(source.path + ": is " + sizeText(image.width, image.height) +
                     "; a latitude-longitude map is twice as wide as high");
  }
  // The same number of texels over the sphere: 6 N² = W²/2.
  if (faceSize == 0) faceSize = nearestFaceSize(image.width / std::sqrt(12.0));
  // Only the envmap attribute means OpenEXR's texels on the edges; all other pictures have them at the centres of
  // cells.
  const TexelPlacement placement = source.picture.envmap ? TexelPlacement::Edges : TexelPlacement::Centres;
  constexpr double kPi = 3.14159265358979323846;
  const double ratio = image.width / (kPi * faceSize);  // picture texels per texel in the middle of a face
  result.radiance = resampleToCube(latLongSampler(image, placement), faceSize, samplesForRatio(ratio));
  if (source.picture.distance.empty()) return;
  const auto nearest = [&](const glm::vec3& direction) {
    const glm::dvec2 point = latLongPoint(direction);
    return distanceAt(source, nearestIndex(point.x, image.width, placement),
                      nearestIndex(point.y, image.height, placement));
  };
  result.distance = nearestToCube(nearest, faceSize);
}

/// A file that says its orientation is not asked for its view.
bool fromInside(bool openExr, CubeView view, PictureRepairs& repairs) {
  if (view == CubeView::Outside) return false;
  if (openExr) repairs.remarks.emplace_back("cubeView has no effect: the file says how its faces lie, as OpenEXR's");
  return !openExr;
}

void convertPicture(const CubeSource& source, CubeLayout layout, int faceSize, CubeView view, LoadedCube& result) {
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
  faces.inside = fromInside(faces.openExr, view, result.repairs);
  convertFaces(faces, faceSize, result);
}

LoadedCube loadSixFiles(const std::string& path, int faceSize, const PictureCode& code, CubeView view,
                        const Finish& finish) {
  const auto names = findSixNames(path);
  if (!names) {
    throw InputError(path +
                     ": the six files of a cube were not found; name them NAME_px, NAME_nx, NAME_py, NAME_ny, "
                     "NAME_pz and NAME_nz, or use a 2:1 latitude-longitude map, a 6:1 strip or a 4:3 cross");
  }
  std::array<CubeSource, 6> sources;
  LoadedCube result;
  result.layout = CubeLayout::SixFiles;
  Faces faces;
  faces.openExr = names->openExr;
  for (std::size_t i = 0; i < 6; ++i) {
    sources[i] = readCubeSource(names->paths[i], code);
    if (sources[i].picture.displayWidth == sources[i].picture.displayHeight) fillDisplayWindow(sources[i]);
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
    result.repairs.notFinite += sources[i].repairs.notFinite;
    result.repairs.negative += sources[i].repairs.negative;
    result.repairs.beyondHalf += sources[i].repairs.beyondHalf;
    for (const std::string& remark : sources[i].repairs.remarks) {
      result.repairs.remarks.push_back(std::filesystem::path(names->paths[i]).filename().string() + ": " + remark);
    }
  }
  faces.inside = fromInside(faces.openExr, view, result.repairs);
  convertFaces(faces, faceSize, result);
  finish(result);
  return result;
}

LoadedCube load(const std::string& path, CubeLayout layout, int faceSize, const PictureCode& code, CubeView view,
                const Finish& finish) {
  if (faceSize < 0 || faceSize > limits::kCubeFace || (faceSize & (faceSize - 1)) != 0) {
    throw InputError(path + ": a face size of " + std::to_string(faceSize) +
                     " was asked for; use a power of two up to " + std::to_string(limits::kCubeFace));
  }
  std::error_code ignored;
  const bool pattern = path.find('%') != std::string::npos && !std::filesystem::exists(path, ignored);
  if (layout == CubeLayout::SixFiles || pattern) return loadSixFiles(path, faceSize, code, view, finish);
  // A baked probe has the exact level and its distances, which its part for other programs lacks.
  const bool mayBeBaked =
      (layout == CubeLayout::Automatic || layout == CubeLayout::Strip) && code.encoding == ImageEncoding::Linear;
  if (mayBeBaked && bakedProbeMark(path)) return fromBaked(loadBakedProbe(path), faceSize, finish);
  CubeSource source = readCubeSource(path, code);
  if (layout == CubeLayout::Automatic) {
    layout = detectLayout(source);
  } else if (!source.picture.envmap) {
    const ExrPicture& p = source.picture;
    const bool display = layoutOfShape(p.displayWidth, p.displayHeight) == layout;
    if (display || layoutOfShape(p.image.width, p.image.height) != layout) fillDisplayWindow(source);
  }
  const ImageRgbaF& image = source.picture.image;
  if (layout == CubeLayout::Automatic) {
    const bool square = source.picture.displayWidth == source.picture.displayHeight;
    if (square || image.width == image.height) return loadSixFiles(path, faceSize, code, view, finish);
    throw InputError(path + ": is " + sizeText(image.width, image.height) +
                     ", which is no layout of a cube; use a 2:1 latitude-longitude map, a 6:1 or 1:6 strip, a 4:3 or "
                     "3:4 cross, or six square files");
  }
  LoadedCube result;
  result.layout = layout;
  result.repairs = source.repairs;
  convertPicture(source, layout, faceSize, view, result);
  finish(result);
  return result;
}

void spreadOut(LoadedCube& cube) {
  spreadBeyondHalf(cube.radiance, cube.repairs);
}

}  // namespace

LoadedCube loadCube(const std::string& path, CubeLayout layout, int faceSize, const PictureCode& code, CubeView view) {
  return load(path, layout, faceSize, code, view, spreadOut);
}

LoadedCube loadSkyCube(const std::string& path, CubeLayout layout, CubeView view, std::optional<SkySun>* sun) {
  return load(path, layout, 0, {}, view, [sun](LoadedCube& cube) {
    if (sun != nullptr) *sun = takeSun(cube.radiance, cube.repairs.beyondHalf);
    spreadOut(cube);
  });
}

LoadedCube loadCustomCube(const Probe& probe, int faceSize) {
  LoadedCube cube = loadCube(probe.image, probe.imageLayout, faceSize, {probe.encoding, probe.decode}, probe.cubeView);
  const double turn = std::remainder(probe.imageRotationDegrees, 360.0);
  if (turn == 0.0) return cube;
  turnMaps(cube.radiance, cube.distance, glm::mat3(glm::transpose(rotationMatrix({0.0, turn, 0.0}))));
  return cube;
}

}  // namespace boxprobe
