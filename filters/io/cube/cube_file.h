// Reads and writes cubemaps: baked probes as OpenEXR files, and environment pictures of any common layout.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/picture_code.h"
#include "filters/io/image/exr_precision.h"

namespace boxprobe {

/// The inputs and the origin of a baked probe.
struct BakedProbeMark {
  std::string inputHash;  ///< of everything the capture depends on; equal hashes mean equal files
  std::string program;    ///< "Boxprobe 0.2"
  std::string renderer;   ///< OpenGL's name of the renderer that captured it; empty in older files
};

/// The metadata of a baked probe's file, stored as EXR attributes.
struct BakedProbeInfo : BakedProbeMark {
  Probe probe;  ///< name, origin, box, rotation, blend distance, technique ... as baked
};

struct BakedProbeFile {
  BakedMaps maps;
  BakedProbeInfo info;
  std::size_t texelsNotFinite = 0;  ///< radiance that was NaN or infinite in the file, replaced by 0
};

/// Writes a probe's file: every level with coverage, distance, irradiance and metadata, exact to half precision and
/// readable by other programs as an environment map. Deterministic. Written to a temporary file and renamed. Throws
/// WorkError.
void saveBakedProbe(const std::string& path, const BakedProbeFile& file, ExrPrecision precision = ExrPrecision::Half);
/// Throws InputError with file, part and attribute, or for a wrong checksum. Files of earlier versions have no
/// checksum.
BakedProbeFile loadBakedProbe(const std::string& path);
/// Hash, program and renderer from the header alone; nothing if the file is missing, truncated or not a baked probe.
/// Never throws; `damage` receives a line if the file cannot be read.
std::optional<BakedProbeMark> bakedProbeMark(const std::string& path, std::string* damage = nullptr);
/// Empty if the checksum matches; else a line that names the file. Never throws.
std::string bakedProbeDamage(const std::string& path);

/// What reading a picture of the surroundings changed, in texels of the file.
struct PictureRepairs {
  std::size_t notFinite = 0;         ///< NaN or infinite, filled in
  std::size_t negative = 0;          ///< negative in a channel, now 0
  std::size_t beyondHalf = 0;        ///< above the largest half float: spread over the directions around
  double lightLost = 0.0;            ///< share of the picture's light that no disc around could take
  std::vector<std::string> remarks;  ///< what the file asks for and does not get

  /// One sentence each, without the file's name.
  std::vector<std::string> sentences() const;
};

struct LoadedCube {
  CubeMap radiance;  ///< one level, OpenGL orientation, alpha = coverage (1 where the file has none)
  CubeMap distance;  ///< empty if the file has none
  CubeLayout layout = CubeLayout::Automatic;  ///< the layout that was found
  PictureRepairs repairs;
};

struct CubePictureOptions {
  int level = 0;                      ///< of the chain
  int faceSize = 0;                   ///< texels; a latitude-longitude map is 4 faces wide. 0: the level's size
  const CubeMap* distance = nullptr;  ///< written as a float channel "distance" if given
  ExrPrecision precision = ExrPrecision::Half;
};
/// Writes one level of a cube as a picture for other programs. LatLong: with OpenEXR's envmap attribute, texels on the
/// edges. Strip (and Automatic): an OpenEXR cube, N x 6N, with the attribute. Cross: 4:3, OpenGL's faces unchanged
/// unless another size is given. SixFiles: `path` has %s for px, nx, py, ny, pz, nz (OpenGL's faces), or a bare % for
/// +X, -X ... as exrenvmap reads and writes them (OpenEXR's). Throws InputError for options out of range, WorkError.
void saveCubePicture(const std::string& path, const CubeMap& cube, CubeLayout layout,
                     const CubePictureOptions& options = {});

/// Reads any environment picture as a cube: EXR or HDR, or an encoded PNG or JPEG. `faceSize` 0: chosen by the
/// picture's resolution (a power of two). For SixFiles `path` is one of the six, or a pattern with `%s` for the face.
/// Encoded texels are decoded before resampling. `view` is of cubes whose files do not say: a picture seen from inside
/// is the one from outside with +X and -X exchanged and every face mirrored. Throws InputError.
LoadedCube loadCube(const std::string& path, CubeLayout layout = CubeLayout::Automatic, int faceSize = 0,
                    const PictureCode& code = {}, CubeView view = CubeView::Outside);
/// The picture of a custom probe, with its fields. `faceSize` as above.
LoadedCube loadCustomCube(const Probe& probe, int faceSize = 0);

}  // namespace boxprobe
