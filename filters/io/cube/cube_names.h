// The six files of a cube by their names. Called by the reader and the writer of cubes; opens no file.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace boxprobe {

struct SixNames {
  std::array<std::string, 6> paths;  ///< OpenGL's order +X -X +Y -Y +Z -Z
  /// Named as exrenvmap names them (+X, -X, ...): faces in OpenEXR's orientation with texels on the edges. All other
  /// names mean OpenGL's.
  bool openExr = false;
};

/// From one of the six (NAMEpx.exr, posx.hdr, right.exr, cube+X.exr ..., in any case) or a pattern with %s (or %) where
/// the face goes: the names that all exist. Nothing if the name is of neither kind or the six are not there.
std::optional<SixNames> findSixNames(const std::string& path);

/// For writing: `pattern` with px, nx ... in place of %s, or +X, -X ... in place of a bare %, which is exrenvmap's own
/// way. Throws InputError without either.
SixNames sixNamesToWrite(const std::string& pattern);

}  // namespace boxprobe
