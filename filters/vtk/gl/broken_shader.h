// What happens on a driver that refuses a shader, made testable on one that does not: the environment variable
// BOXPROBE_BREAK_SHADER holds the name of one, whose text is then spoilt: "surface" (the physically based one with
// probes), "debug" (the same as debug views and explanations draw it), or a file of shaders/gpu that is a pass of its
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
