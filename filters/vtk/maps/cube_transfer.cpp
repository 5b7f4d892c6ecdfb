#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

namespace {

CubeMap read(const CubeTexture& texture) {
  if (!texture.allocated()) return {};
  CubeMap cube(texture.faceSize(), texture.levels());
  for (int level = 0; level < texture.levels(); ++level) {
    for (int face = 0; face < 6; ++face) {
      texture.readFace(face, level, cube.face(level, face));
    }
  }
  return cube;
}

void write(const CubeMap& cube, int level, CubeTexture& texture) {
  const auto size = static_cast<std::size_t>(cube.levelSize(level));
  for (int face = 0; face < 6; ++face) {
    const float* rgba = cube.face(level, face);
    texture.writeFace(face, level, std::vector<float>(rgba, rgba + size * size * 4));
  }
}

void writeAll(const CubeMap& cube, GLenum internalFormat, CubeTexture& texture) {
  if (cube.empty()) return;
  texture.allocate(cube.faceSize(), cube.levels(), internalFormat);
  for (int level = 0; level < cube.levels(); ++level) write(cube, level, texture);
}

}  // namespace

BakedMaps readBack(const ProbeMaps& maps) {
  maps.need(kAllLevels);
  return readBackAsShown(maps);
}

BakedMaps readBackAsShown(const ProbeMaps& maps) {
  BakedMaps result;
  result.radiance = read(maps.radiance);
  result.distance = read(maps.distance);
  result.irradiance = maps.irradiance;
  result.capturedAt = maps.capturedAt;
  result.capturedRotation = maps.capturedRotation;
  return result;
}

CubeMap readRadiance(const ProbeMaps& maps) {
  maps.need(kAllLevels);
  return read(maps.radiance);
}

void readLevel0(const CubeTexture& texture, CubeMap& cube) {
  for (int face = 0; face < 6; ++face) {
    texture.readFace(face, 0, cube.face(0, face));
  }
}

std::shared_ptr<const ProbeMaps> upload(const BakedMaps& maps, bool forTheTimeBeing) {
  auto result = std::make_shared<ProbeMaps>();
  result->forTheTimeBeing = forTheTimeBeing;
  writeAll(maps.radiance, GL_RGBA16F, result->radiance);
  writeAll(maps.distance, GL_R32F, result->distance);
  result->irradiance = maps.irradiance;
  result->capturedAt = maps.capturedAt;
  result->capturedRotation = maps.capturedRotation;
  return result;
}

std::shared_ptr<const ProbeMaps> upload(const SkyLevels& levels) {
  auto result = std::make_shared<ProbeMaps>();
  result->radiance.allocate(levels.faceSize, levels.levels, GL_RGBA16F);
  for (int level = 0; level < levels.levels; ++level) {
    for (int face = 0; face < 6; ++face) {
      result->radiance.writeHalves(face, level, levels.texels.data() + levels.offset(level, face));
    }
  }
  result->irradiance = levels.irradiance;
  return result;
}

void uploadLevel0(const CubeMap& cube, CubeTexture& texture) {
  write(cube, 0, texture);
}

}  // namespace boxprobe
