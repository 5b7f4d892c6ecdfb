// Tests the handling of a refused shader: the environment variable BOXPROBE_BREAK_SHADER names a shader whose source is
// then made invalid: "surface" (the physically based one with probes), "debug" (the same for debug views and
// explanations), "probes" (where a draw has more than one), "constants", or a file of shaders/gpu that is a pass of its
// own.
#pragma once

#include <cstdlib>
#include <string>

namespace boxprobe {

inline void breakShaderIfAsked(std::string& source, const std::string& name) {
  const char* broken = std::getenv("BOXPROBE_BREAK_SHADER");
  if (broken != nullptr && name == broken) source += "\n#error broken on purpose by BOXPROBE_BREAK_SHADER\n";
}

}  // namespace boxprobe
