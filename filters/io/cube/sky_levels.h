// The prefiltered levels of a sky's picture, shipped beside it: studio.levels for studio.hdr. Texels are stored as
// OpenGL takes them, so reading is one copy. Written by data/environments/generate_levels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filters/core/picture/baked_probe.h"

namespace boxprobe {

struct SkyLevels {
  std::string key;                    ///< of their inputs (skyKey, 32 characters)
  int faceSize = 0, levels = 0;       ///< texels; level l has `faceSize >> l`
  ShCoefficients irradiance{};        ///< as from irradianceCoefficients()
  std::vector<std::uint16_t> texels;  ///< half floats, RGBA: level by level, each with OpenGL's six faces in order

  /// The offset of a face in `texels`.
  std::size_t offset(int level, int face) const;
};

/// The path of the levels that belong to a picture, whether or not the file exists.
std::string skyLevelsFile(const std::string& picture);

/// Does `path` hold levels of that key and size? Reads only its first bytes; false for any other file.
bool holdsSkyLevels(const std::string& path, const std::string& key, int faceSize);

/// Throws InputError for a file of another kind, or one that is truncated or damaged.
SkyLevels loadSkyLevels(const std::string& path);

/// `maps` without distances. Throws WorkError.
void saveSkyLevels(const std::string& path, const std::string& key, const BakedMaps& maps);

}  // namespace boxprobe
