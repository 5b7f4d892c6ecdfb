// The prefiltered levels of a sky's picture, made once and shipped beside it: studio.levels for studio.hdr. Texels
// stand as OpenGL takes them, so that reading them is one copy. Written by data/environments/generate_levels, read by
// whoever lights a scene with that picture. Knows neither OpenGL nor VTK.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filters/core/picture/baked_probe.h"

namespace boxprobe {

struct SkyLevels {
  std::string key;                    ///< of what they were made from (skyKey, 32 characters)
  int faceSize = 0, levels = 0;       ///< texels; level l has `faceSize >> l`
  ShCoefficients irradiance{};        ///< as irradianceCoefficients() gives it
  std::vector<std::uint16_t> texels;  ///< half floats, RGBA: level by level, in each the six faces of OpenGL

  /// Where a face begins in `texels`.
  std::size_t offset(int level, int face) const;
};

/// The file of levels that belongs to a picture, whether it is there or not.
std::string skyLevelsFile(const std::string& picture);

/// Whether `path` holds levels of that key and size. Reads no more than its first bytes; false for any other file.
bool holdsSkyLevels(const std::string& path, const std::string& key, int faceSize);

/// Throws InputError for a file that is no such file, too short or damaged.
SkyLevels loadSkyLevels(const std::string& path);

/// `maps` without distances. Throws WorkError.
void saveSkyLevels(const std::string& path, const std::string& key, const BakedMaps& maps);

}  // namespace boxprobe
