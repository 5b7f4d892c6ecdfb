// What sub-commands draw with, and what a driver has to have. Plain values.
#pragma once

#include <string>

namespace boxprobe {

enum class Offscreen {
  Automatic,  ///< an X display if there is one, else EGL
  X,
  Egl,
  Osmesa,  ///< Mesa without any window system, where VTK was built for it
};

/// What the project needs and an OpenGL does not have, for one line; empty: nothing. `version`: 10 * major + minor;
/// `floatTargets`: can it draw into RGBA32F?
inline std::string missingFromOpenGl(int version, bool floatTargets) {
  if (version < 32) {
    return "OpenGL " + std::to_string(version / 10) + "." + std::to_string(version % 10) + " (3.2 is needed)";
  }
  return floatTargets ? "" : "no drawing into textures of 32-bit floats (RGBA32F)";
}

}  // namespace boxprobe
