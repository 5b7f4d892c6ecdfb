// The names of the six files of a cube.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace boxprobe {

struct SixNames {
  std::array<std::string, 6> paths;  ///< OpenGL's order +X -X +Y -Y +Z -Z
  /// Named as by exrenvmap (+X, -X, ...): faces in OpenEXR's orientation with texels on the edges. All other names mean
  /// OpenGL's.
  bool openExr = false;
};

/// The names of all six files, given one of them (NAMEpx.exr, posx.hdr, right.exr, cube+X.exr ..., in any case) or a
/// pattern with %s (or %) for the face. Nothing if the name fits no scheme or a file is missing.
std::optional<SixNames> findSixNames(const std::string& path);

/// For writing: `pattern` with px, nx ... in place of %s, or with +X, -X ... in place of a bare %, as exrenvmap does.
/// Throws InputError without either.
SixNames sixNamesToWrite(const std::string& pattern);

}  // namespace boxprobe
