// Cubemaps in and out: baked probes as OpenEXR files, and environment pictures of any common layout as cubes. Written
// by `boxprobe bake` and the window, read for `custom` probes and the bake cache. Knows neither VTK nor Qt.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/picture_code.h"
#include "filters/io/image/exr_precision.h"

namespace boxprobe {

/// Of what, and by what, a baked probe was made.
struct BakedProbeMark {
  std::string inputHash;  ///< of everything the capture depends on; equal hashes, equal files
  std::string program;    ///< "Boxprobe 0.2"
  std::string renderer;   ///< OpenGL's name of what captured it; empty in earlier files
};

/// What a baked probe's file says about itself, as EXR attributes.
struct BakedProbeInfo : BakedProbeMark {
  Probe probe;  ///< name, origin, box, rotation, blend distance, technique ... as baked
};

struct BakedProbeFile {
  BakedMaps maps;
  BakedProbeInfo info;
  std::size_t texelsNotFinite = 0;  ///< radiance that was NaN or infinite in the file, replaced by 0
};

/// Our own file of a probe: every level with coverage, distance, irradiance and metadata, exact to half precision and
/// readable as an environment map by others. Equal input, equal bytes. Written to a temporary file and renamed. Throws
/// WorkError.
void saveBakedProbe(const std::string& path, const BakedProbeFile& file, ExrPrecision precision = ExrPrecision::Half);
/// Throws InputError naming file, part and attribute, or a checksum that differs. Files of earlier versions have none.
BakedProbeFile loadBakedProbe(const std::string& path);
/// Its hash, program and renderer, from the header alone; nothing if the file is missing, cut off or not one of ours.
/// Never throws; `damage` receives a line if the file cannot be read.
std::optional<BakedProbeMark> bakedProbeMark(const std::string& path, std::string* damage = nullptr);
/// Empty if every byte of the file is as it was written, by its checksum; else a line that names it. Never throws.
std::string bakedProbeDamage(const std::string& path);

struct LoadedCube {
  CubeMap radiance;  ///< one level, OpenGL orientation, alpha = coverage (1 where the file has none)
  CubeMap distance;  ///< empty if the file has none
  CubeLayout layout = CubeLayout::Automatic;  ///< the one found
  std::size_t texelsNotFinite = 0;            ///< replaced by 0
  std::size_t texelsClamped = 0;              ///< beyond half range, brought down to it
};

struct CubePictureOptions {
  int level = 0;                      ///< of the chain
  int faceSize = 0;                   ///< texels; a latitude-longitude map is 4 faces wide. 0: as the level has
  const CubeMap* distance = nullptr;  ///< written as a float channel "distance" if given
  ExrPrecision precision = ExrPrecision::Half;
};
/// One level of a cube as a picture for others. LatLong: with OpenEXR's envmap attribute, texels on the edges. Strip
/// (and Automatic): an OpenEXR cube, N x 6N, with the attribute. Cross: 4:3, OpenGL's faces as they are unless another
/// size is asked for. SixFiles: `path` has %s for px, nx, py, ny, pz, nz (OpenGL's faces), or a bare % for +X, -X ...
/// as exrenvmap reads and writes them (OpenEXR's). Throws InputError for options out of range, WorkError.
void saveCubePicture(const std::string& path, const CubeMap& cube, CubeLayout layout,
                     const CubePictureOptions& options = {});

/// Any environment picture as a cube: EXR or HDR, or a PNG or JPEG whose code is given. `faceSize` 0: as many texels as
/// the picture gives (a power of two). For SixFiles `path` is one of the six, or a pattern with `%s` for the face.
/// Encoded texels are decoded before they are resampled. Throws InputError.
LoadedCube loadCube(const std::string& path, CubeLayout layout = CubeLayout::Automatic, int faceSize = 0,
                    const PictureCode& code = {});

}  // namespace boxprobe
