// A baked probe's file. Part 0, "environment", is for other programs: a mip-mapped OpenEXR cube with the envmap
// attribute and the metadata, resampled because OpenEXR's texels lie on the edges of faces. Parts "level.0" and up hold
// every level's texels unchanged, as OpenGL's faces from the top down; part "distance" one float channel. These exact
// parts lie along the axes of the probe's box, part 0 along the world's. Both forms are needed: the standard one is not
// exact, the exact one is not standard.
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/matrix.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/cube/cube_attributes.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/cube/cube_resample.h"
#include "filters/io/cube/cube_seal.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/exr_reader.h"
#include "filters/io/image/exr_writer.h"

namespace boxprobe {

namespace {

constexpr int kVersion = 2, kUnsealedVersion = 1;  // 1: without a checksum
constexpr int kMostLevels = 13;                    // of 4096² faces
constexpr const char* kVersionAttribute = "boxprobe";
constexpr const char* kLevelsAttribute = "levels";
// Degrees about X, then Y, then Z: rotation of the axes of the exact parts. Absent: the world's axes.
constexpr const char* kRotationAttribute = "capturedRotation";
constexpr const char* kComments =
    "Part environment: OpenEXR cube, level l filtered for the roughness of the probe's level l. Parts level.N: the "
    "same, exact, OpenGL faces +X -X +Y -Y +Z -Z from the top down, texels at cell centres; along axes turned by "
    "capturedRotation, if it is there. Part distance: from the "
    "capture origin, scene units, 0 where nothing was seen. Linear Rec. 709, premultiplied; A is coverage.";

std::string parentFolder(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

std::string levelName(int level) {
  return "level." + std::to_string(level);
}

/// A level of the environment part. Below one texel per face OpenEXR's chain continues with 1 x 3 and 1 x 1: the mean.
ExrLevel environmentLevel(const CubeMap& radiance, const glm::dmat3& mapFromWorld, int level, ExrPrecision precision) {
  const int width = std::max(radiance.faceSize() >> level, 1), height = std::max((6 * radiance.faceSize()) >> level, 1);
  ExrLevel result{width, height, {}};
  std::vector<float> pixels(std::size_t(4) * width * height);
  if (height == 6 * width) {
    const auto source = [&](const glm::vec3& direction) {
      return radiance.fetch(glm::vec3(mapFromWorld * glm::dvec3(direction)), static_cast<float>(level));
    };
    for (int face = 0; face < 6; ++face) {
      resampleToOpenExrFace(source, face, width, 1, &pixels[std::size_t(4) * face * width * width]);
    }
  } else {
    glm::vec4 mean(0.0f);
    for (int face = 0; face < 6; ++face) {
      mean += radiance.fetch(shading::cubeDirection(face, 0.0f, 0.0f), radiance.maxLevel()) / 6.0f;
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = mean[static_cast<int>(i % 4)];
  }
  addRgba(result, pixels.data(), precision);
  return result;
}

ExrPart environmentPart(const CubeMap& radiance, const glm::dmat3& mapFromWorld, ExrPrecision precision) {
  constexpr unsigned kTile = 64;  // exrenvmap's own default
  const int size = radiance.faceSize();
  ExrPart part{Imf::Header(size, 6 * size), {}};
  part.header.setName("environment");
  part.header.setTileDescription(Imf::TileDescription(kTile, kTile, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN));
  Imf::addEnvmap(part.header, Imf::ENVMAP_CUBE);
  for (int level = 0; (6 * size) >> level > 0; ++level) {
    part.levels.push_back(environmentLevel(radiance, mapFromWorld, level, precision));
  }
  return part;
}

ExrPart stackPart(const std::string& name, int size, const Imath::Box2i& displayWindow) {
  ExrPart part = exrPart(size, 6 * size);
  part.header.setName(name);
  part.header.displayWindow() = displayWindow;  // OpenEXR requires the same in all parts of a file
  return part;
}

int partNamed(const Imf::MultiPartInputFile& file, const std::string& name) {
  for (int part = 0; part < file.parts(); ++part) {
    if (file.header(part).hasName() && file.header(part).name() == name) return part;
  }
  return -1;
}

int versionOf(const Imf::MultiPartInputFile& file) {
  const auto* version = file.header(0).findTypedAttribute<Imf::IntAttribute>(kVersionAttribute);
  return version == nullptr ? 0 : version->value();
}

/// Requires the exact levels, not only the attribute: exrenvmap copies every attribute into its output.
bool isBakedProbe(const Imf::MultiPartInputFile& file) {
  const int version = versionOf(file);
  return (version == kVersion || version == kUnsealedVersion) && partNamed(file, levelName(0)) > 0;
}

float finiteOrZero(float value) {
  return std::isfinite(value) ? value : 0.0f;
}

/// Returns the number of texels that were not finite.
std::size_t readLevel(Imf::MultiPartInputFile& file, CubeMap& cube, int level, const std::string& path) {
  const int part = partNamed(file, levelName(level));
  if (part < 0) throw InputError(path + ": has no part " + levelName(level) + "; bake it again");
  const int size = cube.levelSize(level);
  const ExrPicture picture = readExrPart(file, part, path);
  if (picture.image.width != size || picture.image.height != 6 * size) {
    throw InputError(path + ": part " + std::to_string(part) + ": is " + std::to_string(picture.image.width) + " x " +
                     std::to_string(picture.image.height) + " pixels and must be " + std::to_string(size) + " x " +
                     std::to_string(6 * size) + "; bake it again");
  }
  const std::vector<float>& pixels = picture.image.pixels;
  std::transform(pixels.begin(), pixels.end(), cube.face(level, 0), finiteOrZero);
  std::size_t notFinite = 0;
  for (std::size_t texel = 0; texel < pixels.size(); texel += 4) {
    const auto start = pixels.begin() + static_cast<std::ptrdiff_t>(texel);
    notFinite += std::all_of(start, start + 4, [](float v) { return std::isfinite(v); }) ? 0 : 1;
  }
  return notFinite;
}

BakedMaps readMaps(Imf::MultiPartInputFile& file, const std::string& path, std::size_t& notFinite) {
  const Imf::Header& header = file.header(0);
  if (!isBakedProbe(file)) {
    throw InputError(path + ": attribute " + kVersionAttribute + " = " + std::to_string(kVersion) + " and a part " +
                     levelName(0) + " are not there: no probe baked by this version; bake it again");
  }
  BakedMaps maps;
  maps.capturedAt = vectorAttribute(header, "capturedAt", path);
  if (header.find(kRotationAttribute) != header.end()) {
    maps.capturedRotation = vectorAttribute(header, kRotationAttribute, path);
  }
  maps.irradiance = readCoefficients(header, path);
  const Imath::Box2i window = header.dataWindow();
  const long long size = static_cast<long long>(window.max.x) - window.min.x + 1;
  const auto* levels = header.findTypedAttribute<Imf::IntAttribute>(kLevelsAttribute);
  if (levels == nullptr || levels->value() < 1 || levels->value() > kMostLevels || size < 1 ||
      size > (1LL << (kMostLevels - 1)) || size >> (levels->value() - 1) < 1) {
    throw InputError(path + ": part 0: attribute " + kLevelsAttribute + " does not fit faces of " +
                     std::to_string(size) + " texels; bake it again");
  }
  // Before the chain is allocated: sizes that the file cannot contain must not allocate memory.
  for (int level = 0; level < levels->value(); ++level) {
    if (partNamed(file, levelName(level)) < 0) {
      throw InputError(path + ": has no part " + levelName(level) + "; bake it again");
    }
  }
  maps.radiance = CubeMap(static_cast<int>(size), levels->value());
  for (int level = 0; level < maps.radiance.levels(); ++level) notFinite += readLevel(file, maps.radiance, level, path);
  if (const int part = partNamed(file, "distance"); part >= 0) {
    const Imath::Box2i distanceWindow = file.header(part).dataWindow();
    const long long side = static_cast<long long>(distanceWindow.max.x) - distanceWindow.min.x + 1;
    if (side < 1 || side > (1LL << (kMostLevels - 1))) {
      throw InputError(path + ": part distance: has faces of " + std::to_string(side) + " texels; bake it again");
    }
    const int faceSize = static_cast<int>(side);
    const std::vector<float> values = readExrChannel(file, part, "distance", faceSize, 6 * faceSize, path);
    maps.distance = CubeMap(faceSize, 1);
    float* texels = maps.distance.face(0, 0);
    for (std::size_t i = 0; i < values.size(); ++i) texels[4 * i] = std::max(finiteOrZero(values[i]), 0.0f);
  }
  return maps;
}

}  // namespace

void saveBakedProbe(const std::string& path, const BakedProbeFile& file, ExrPrecision precision) {
  const CubeMap& radiance = file.maps.radiance;
  const int size = radiance.faceSize();
  if (radiance.empty() || (size & (size - 1)) != 0 || radiance.levels() > kMostLevels ||
      size >> (radiance.levels() - 1) < 1) {
    throw WorkError(path + ": not written: faces of " + std::to_string(size) + " texels with " +
                    std::to_string(radiance.levels()) + " levels are no probe's; use a power of two");
  }
  std::vector<ExrPart> parts;
  parts.reserve(static_cast<std::size_t>(radiance.levels()) +
                2);  // reallocation would copy OpenEXR's headers with their pictures
  const bool turned = file.maps.capturedRotation != glm::dvec3(0.0);
  const glm::dmat3 mapFromWorld = turned ? glm::transpose(rotationMatrix(file.maps.capturedRotation)) : glm::dmat3(1.0);
  parts.push_back(environmentPart(radiance, mapFromWorld, precision));
  Imf::Header& header = parts.front().header;
  const Imath::Box2i displayWindow = header.displayWindow();
  for (int level = 0; level < radiance.levels(); ++level) {
    ExrPart part = stackPart(levelName(level), radiance.levelSize(level), displayWindow);
    addRgba(part.levels.front(), radiance.face(level, 0), precision);
    parts.push_back(std::move(part));
  }
  // The finest level has most of the bytes and the least compressible content. PIZ builds a table per block, which
  // dominates for small blocks: tiles and coarse levels.
  for (ExrPart& part : parts) part.header.compression() = Imf::ZIP_COMPRESSION;
  parts[1].header.compression() = chooseCompression(parts[1].levels.front());
  if (!file.maps.distance.empty()) {
    ExrPart part = stackPart("distance", file.maps.distance.faceSize(), displayWindow);
    addPlane(part.levels.front(), "distance", file.maps.distance.face(0, 0), 4, ExrPrecision::Float);
    part.header.compression() = Imf::PIZ_COMPRESSION;  // smaller than ZIP in every scene tested
    parts.push_back(std::move(part));
  }

  Imf::Header& metadata = parts.front().header;
  addProbeAttributes(metadata, file.info, parentFolder(path));
  addCoefficients(metadata, file.maps.irradiance);
  addVectorAttribute(metadata, "capturedAt", file.maps.capturedAt);
  if (turned) addVectorAttribute(metadata, kRotationAttribute, file.maps.capturedRotation);
  metadata.insert(kVersionAttribute, Imf::IntAttribute(kVersion));
  addSeal(metadata);
  metadata.insert(kLevelsAttribute, Imf::IntAttribute(radiance.levels()));
  Imf::addComments(metadata, kComments);
  saveExrParts(path, std::move(parts), seal);
}

BakedProbeFile loadBakedProbe(const std::string& path) {
  BakedProbeFile result;
  const Seal found = checkSeal(readWholeFile(path));
  if (found == Seal::Broken) throw InputError(path + ": is damaged: its checksum differs; bake it again");
  withExrFile(path, [&](Imf::MultiPartInputFile& file) {
    if (found == Seal::None && versionOf(file) == kVersion) {
      throw InputError(path + ": is damaged: it has no checksum; bake it again");
    }
    result.maps = readMaps(file, path, result.texelsNotFinite);
    result.info = readProbeAttributes(file.header(0), parentFolder(path), path);
  });
  return result;
}

std::optional<BakedProbeMark> bakedProbeMark(const std::string& path, std::string* damage) {
  std::optional<BakedProbeMark> mark;
  try {
    withExrFile(path, [&](Imf::MultiPartInputFile& file) {
      if (!isBakedProbe(file)) return;
      for (int part = 0; part < file.parts(); ++part) {
        if (!file.partComplete(part)) throw InputError(path + ": is cut off; bake it again");
      }
      mark = readProbeMark(file.header(0), path);
    });
  } catch (const std::exception& problem) {
    if (damage != nullptr) *damage = problem.what();
    return std::nullopt;  // an unreadable cache counts as empty
  }
  return mark;
}

std::string bakedProbeDamage(const std::string& path) {
  try {
    if (checkSeal(readWholeFile(path)) == Seal::Whole) return {};
    return path + ": is damaged, or from an earlier version: its checksum differs or is missing";
  } catch (const std::exception& problem) {
    return problem.what();
  }
}

}  // namespace boxprobe
