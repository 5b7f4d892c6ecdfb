#include "filters/io/engines/light_text.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "filters/io/engines/shader_literals.h"
#include "filters/math/shared/shader_source.h"

namespace boxprobe {

namespace {

std::string source(std::string_view file) {
  return std::string(shaderSource(file)) + "\n";
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// A texture is no member of a structure in these languages: it goes along with the lattice.
std::string latticeText() {
  std::string text = source("shared/lattice.glsl");
  for (const auto& [from, to] : {std::pair{"(LatticeShape lattice,", "(sampler3D nodes, LatticeShape lattice,"},
                                 std::pair{"fetchLattice(lattice.slot, ", "fetchLattice(nodes, lattice, "},
                                 std::pair{"(lattice, ", "(nodes, lattice, "}}) {
    text = replaced(std::move(text), from, to);
  }
  return source("shared/lattice_types.glsl") + source("shared/sh.glsl") + source("exported/fetch_lattice.glsl") + text +
         source("exported/lattice.glsl");
}

/// All of these languages read plane.xyz, GLSL alone vec3(plane).
std::string lampFunctions() {
  return source("shared/lamp_types.glsl") + source("shared/lamp_plane.glsl") + source("exported/lamp.glsl") +
         replaced(source("shared/lamp.glsl"), "vec3(plane)", "plane.xyz") + source("exported/lamp_light.glsl");
}

std::string lampOf(const SceneLamp& lamp, std::size_t number) {
  std::string text = "  if (number == " + std::to_string(number) + ")\n  {\n";
  for (std::size_t i = 0; i < lamp.corners.size(); ++i) {
    text += "    lamp.corners[" + std::to_string(i) + "] = " + shaderVector(lamp.corners[i]) + ";\n";
  }
  return text + "    lamp.count = " + std::to_string(lamp.corners.size()) +
         ";\n    lamp.bothSides = " + (lamp.bothSides ? "true" : "false") +
         ";\n    lamp.radiance = " + shaderVector(lamp.radiance) + ";\n  }\n";
}

}  // namespace

std::string lightText(const std::vector<SceneLamp>& lamps) {
  std::string text = latticeText();
  if (lamps.empty()) return text;
  text += lampFunctions() + "const int kBoxprobeLamps = " + std::to_string(lamps.size()) +
          ";\n\n// The scene's lamps, the strongest first.\nBoxprobeLamp boxprobeLamp(int number)\n{\n"
          "  BoxprobeLamp lamp;\n"
          "  for (int i = 0; i < kLampCorners; ++i) { lamp.corners[i] = vec3(0.0f); }\n"
          "  lamp.count = 3;\n  lamp.bothSides = false;\n  lamp.radiance = vec3(0.0f);\n";
  for (std::size_t i = 0; i < lamps.size(); ++i) text += lampOf(lamps[i], i);
  return text + "  return lamp;\n}\n\n";
}

}  // namespace boxprobe
