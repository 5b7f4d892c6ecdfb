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
  return source("shared/lattice_types.glsl") + source("shared/sh.glsl") +
         "vec4 fetchLattice(sampler3D nodes, LatticeShape lattice, vec3 place, int part)\n{\n"
         "  vec3 count = lattice.last + vec3(1.0f);\n"
         "  float parts = lattice.cut > 0.0f ? 10.0f : 7.0f;\n"
         "  vec3 at = place + vec3(0.5f) + vec3(0.0f, 0.0f, count.z * float(part));\n"
         "  return textureLod(nodes, at / vec3(count.x, count.y, count.z * parts), 0.0f);\n}\n\n" +
         text +
         "// Irradiance over pi at a surface, without lamps: from a lattice of BOXPROBE_reflection_probes in a .glb. "
         "`nodes`: its texels, and\n// those of its `cuts` if it has any, one after another along z, linear and "
         "clamped "
         "to the edge; `count`, `low`, `high`: its\n// `nodes`, `min` and `max`. World space; the normal unit.\n"
         "vec3 boxprobeLattice(sampler3D nodes, BoxprobeProbe boxprobe, vec3 count, vec3 low, vec3 high, bool cuts, "
         "vec3 "
         "position,\n                     vec3 normal)\n{\n"
         "  LatticeShape lattice;\n  lattice.low = low;\n  lattice.last = count - vec3(1.0f);\n"
         "  lattice.perUnit = lattice.last / max(high - low, vec3(1.0e-30f));\n  lattice.cut = cuts ? 1.0f : 0.0f;\n"
         "  lattice.slot = 0;\n"
         "  return latticeIrradiance(nodes, lattice, boxprobeTurned(boxprobe, position - boxprobe.origin),\n"
         "                           boxprobeTurned(boxprobe, normal), normal);\n}\n\n";
}

std::string lampFunctions() {
  return source("shared/lamp_types.glsl") +
         "// A lamp of the scene: a flat convex polygon that shines evenly. World space, scene units.\n"
         "struct BoxprobeLamp\n{\n  vec3 corners[kLampCorners];  // counterclockwise as the shining side is seen\n"
         "  int count;                   // of them\n  bool bothSides;\n  vec3 radiance;\n};\n\n" +
         source("shared/lamp_plane.glsl") +
         "int lampCornerCount(BoxprobeLamp lamp)\n{\n  return lamp.count;\n}\n\n"
         "vec3 lampCorner(BoxprobeLamp lamp, int i)\n{\n  return lamp.corners[i];\n}\n\n"
         "vec4 lampPlane(BoxprobeLamp lamp)\n{\n"
         "  return lampPlaneThrough(lamp.corners[0], lamp.corners[1], lamp.corners[2]);\n}\n\n"
         "bool lampShinesBothSides(BoxprobeLamp lamp)\n{\n  return lamp.bothSides;\n}\n\n" +
         replaced(source("shared/lamp.glsl"), "vec3(plane)", "plane.xyz") +
         "// Irradiance over pi of a lamp at a surface that sees all of it. World space; the normal unit.\n"
         "vec3 boxprobeLampDiffuse(BoxprobeLamp lamp, vec3 position, vec3 normal)\n{\n"
         "  return lampDiffuse(lamp, position, normal) * lamp.radiance;\n}\n\n";
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
