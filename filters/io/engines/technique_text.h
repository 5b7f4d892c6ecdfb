// A technique as one self-contained function for another program, assembled from the same shader files that this
// program draws with.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

enum class ShaderLanguage {
  Glsl,   ///< GLSL 3.30 and later, GLSL ES 3.00
  Hlsl,   ///< Direct3D 11 and later (shader model 5)
  Godot,  ///< an include file of Godot 4's shader language
};

/// Functions and constants without main, uniforms or preprocessor directives: `boxprobeReflection(map, shape, position,
/// normal, view, roughness)` returns what the probe reflects (premultiplied radiance, coverage), and one function per
/// probe returns its shape; with lightText() of the lamps. World space, scene units; the cubemap is one of `--ladder
/// own`. `technique`: id, for every probe. Throws InputError for techniques that need further textures of the program.
std::string techniqueText(const std::vector<Probe>& probes, const std::string& technique, ShaderLanguage language,
                          const std::string& writer, const std::vector<SceneLamp>& lamps = {});

/// Every technique that needs only a cubemap, for a host that assembles programs at run time: named pieces of GLSL, and
/// for each technique its pieces in order. The host must define PROBE_MAP as samplerCube and, with `bevelled`,
/// BP_BEVEL. They end with BoxprobeProbe and boxprobeReflection as in techniqueText().
struct TechniquePieces {
  std::map<std::string, std::string> texts;
  struct Row {
    std::string projection, projectionLabel, evaluation, evaluationLabel;
    std::vector<std::string> pieces;
  };
  std::vector<Row> rows;
};
TechniquePieces techniquePieces(bool bevelled, bool occluded);

}  // namespace boxprobe
