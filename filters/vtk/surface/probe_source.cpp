#include "filters/vtk/surface/probe_source.h"

#include <set>
#include <string_view>
#include <vector>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/surface/text_replace.h"

namespace boxprobe {

namespace {

std::string parameterDeclarations(const ProbeBinding& binding) {
  std::string text;
  if (binding.firstBounce) return text;
  for (const ParameterRow* row : binding.parameters()) {
    if (row->number != nullptr) text += "uniform float " + parameterUniform(*row) + "[BP_SLOTS];\n";
  }
  return text;
}

// The parameters of a slot's technique: numbers from uniforms, choices as constants, so that the compiler removes
// unused code.
std::string parameterAssignments(const ProbeBinding& binding, std::size_t slot) {
  if (binding.firstBounce) return {};
  std::string text;
  for (const ParameterRow* row : parametersOf(binding.technique(slot))) {
    if (row->number == nullptr && row->choice == nullptr) continue;  // concerns the picture, not the lookup
    const std::string value = row->choice != nullptr ? std::to_string(binding.values(slot).*row->choice)
                                                     : parameterUniform(*row) + "[" + std::to_string(slot) + "]";
    text += "  probe.parameters." + std::string(row->name) + " = " + value + ";\n";
  }
  return text;
}

std::string perSlot(std::string_view pattern, const ProbeBinding& binding) {
  const std::vector<int> groups = binding.groups();
  std::string text;
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) {
    const Technique technique = binding.technique(slot);
    std::string piece(pattern);
    // Only where the sky shows through: software renderers do not skip branches.
    const bool open = binding.probes[slot]->open;
    const bool byLookup = binding.openByLookup(slot);
    replaceAll(piece, "@SPECULAR@",
               binding.firstBounce ? "  vec3 specular = vec3(0.0f);\n"
               : byLookup
                   ? "  bpOpenFrom = point.position;\n  bpOpenAlpha = roughness * roughness;\n  bpOpenHere = true;\n"
                     "  vec3 specular = @EVALUATE@(bpMap@SLOT@, probe, point).rgb;\n  bpOpenHere = false;\n"
               : open ? "  vec4 local = @EVALUATE@(bpMap@SLOT@, probe, point);\n  vec3 specular = local.rgb;\n"
                      : "  vec3 specular = @EVALUATE@(bpMap@SLOT@, probe, point).rgb;\n");
    if (binding.lampFree(slot) && !binding.firstBounce) {
      replaceOnce(piece, "vec3 specular = @EVALUATE@(bpMap@SLOT@, probe, point).rgb;",
                  "vec3 specular = bpWithoutLamps(@EVALUATE@(bpMap@SLOT@, probe, point), @SLOT@, weight, "
                  "light.lampsInMap);");
    }
    replaceAll(piece, "@OPEN_SKY@", open && !byLookup ? std::string(shaderSource("gpu/open_sky.glsl")) : std::string());
    replaceAll(piece, "@SLOT@", std::to_string(slot));
    replaceAll(piece, "@GROUP@", std::to_string(groups[slot]));
    const ProbeGeometry& geometry = binding.probes[slot]->geometry;
    const std::string index = "[" + std::to_string(slot) + "]";
    replaceAll(piece, "@BEVEL@",
               geometry.bevelled ? "bpBevel" + index + ".x + bpBevel" + index + ".y * roughness" : "0.0f");
    replaceAll(piece, "@OCCLUDED@", geometry.occluded && !binding.firstBounce ? "1" : "0");
    replaceAll(piece, "@PROJECTION@", std::to_string(technique.projection));
    replaceAll(piece, "@EVALUATE@",
               std::string(evaluationRows()[static_cast<std::size_t>(technique.evaluation)].function));
    replaceAll(piece, "@SMOOTHED@", binding.blurred(slot) ? "1.0f" : "0.0f");
    replaceAll(piece, "@PARAMETERS@", parameterAssignments(binding, slot));
    text += piece;
  }
  return text;
}

// The shader files and the dispatch for this draw's techniques only.
std::string techniqueSources(const ProbeBinding& binding, bool debug) {
  std::vector<std::string> projectionFiles, evaluationFiles, dispatched;
  // Techniques and the debug view may depend on the same file.
  std::set<std::string_view> present;
  if (debug) present.insert("shared/cube.glsl");
  if (binding.lampLobes) present.insert("shared/lobe_frame.glsl");
  const auto addOnce = [&present](std::vector<std::string>& files, std::string_view file) {
    if (!present.insert(file).second) return false;
    files.emplace_back(file);
    return true;
  };
  std::string dispatch;
  bool openByLookup = false;
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) openByLookup |= binding.openByLookup(slot);
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) {
    const Technique t = binding.technique(slot);
    const ProjectionRow& projection = projectionRows()[static_cast<std::size_t>(t.projection)];
    const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(t.evaluation)];
    for (const std::string_view file : projection.sharedFiles) addOnce(projectionFiles, file);
    addOnce(projectionFiles, projection.shaderFile);
    if (addOnce(dispatched, projection.id)) {
      dispatch += "  if (probe.projection == " + std::to_string(t.projection) + ") { return " +
                  std::string(projection.function) + "(probe, position, normal, reflection); }\n";
    }
    for (const std::string_view file : evaluation.sharedFiles) addOnce(evaluationFiles, file);
    addOnce(evaluationFiles, evaluation.shaderFile);
  }
  if (binding.probes.empty() || binding.firstBounce) return {};
  const auto& first = projectionRows()[static_cast<std::size_t>(binding.technique(0).projection)];
  return (binding.bevelled() ? joinShaderSources({"shared/rounded_box.glsl"}) : std::string()) +
         (binding.occluded() ? joinShaderSources({"shared/box_occlusion.glsl"}) : std::string()) +
         joinShaderSources(projectionFiles) +
         "ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n{\n" + dispatch +
         "  return " + std::string(first.function) +
         "(probe, position, normal, reflection);\n}\n#define DISTANCE_MAP samplerCube\n" +
         (debug ? joinShaderSources({"gpu/debug_distance.glsl", "shared/true_hit.glsl"}) : std::string()) +
         (openByLookup ? joinShaderSources({"shared/open_lookup.glsl", "gpu/fetch_probe_open.glsl"})
                       : joinShaderSources({"gpu/fetch_probe.glsl"})) +
         joinShaderSources({"gpu/fetch_blue_noise.glsl", "gpu/fetch_light.glsl", "shared/level_curve.glsl"}) +
         joinShaderSources(evaluationFiles);
}

// The variants of the impostor in use: BP_MARCH of technique/projection_impostor.glsl.
int marchForms(const ProbeBinding& binding) {
  bool few = false, many = false;
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) {
    if (!projectionRows()[static_cast<std::size_t>(binding.technique(slot).projection)].distances) continue;
    (binding.marches(slot) ? many : few) = true;
  }
  return !many ? 0 : few ? 1 : 2;
}

}  // namespace

std::string parameterUniform(const ParameterRow& row) {
  return "bp_" + std::string(row.name);
}

std::string probeDeclarations(const ProbeBinding& binding, SurfaceOutput output, bool mirror, bool flatMaps) {
  const bool debug = output == SurfaceOutput::Debug;
  const std::vector<int> groups = binding.groups();
  std::string lighting(shaderSource("gpu/probe_lighting.glsl"));
  std::string samplers;
  for (std::size_t slot = 0; debug && slot < binding.probes.size(); ++slot) {
    samplers += "uniform samplerCube bpDistanceMap" + std::to_string(slot) + ";\n";
  }
  if (binding.distances() && !binding.firstBounce)
    samplers += joinShaderSources({"shared/relief.glsl", "gpu/fetch_relief.glsl"});
  // Only compiled in scenes with planar mirrors.
  if (mirror) {
    samplers += "#define MIRROR_PICTURE int\n" +
                joinShaderSources({"shared/mirror_types.glsl", "gpu/mirror_picture.glsl", "shared/planar_mirror.glsl"});
  }
  replaceOnce(lighting, "//BP::Distances", samplers);
  replaceOnce(lighting, "//BP::Slots",
              techniqueSources(binding, debug) + parameterDeclarations(binding) +
                  perSlot(shaderSource("gpu/probe_slot.glsl"), binding));
  const bool lattice = binding.shapes && binding.diffuse, sights = binding.sights();
  replaceOnce(lighting, "//BP::Lattice",
              (lattice || sights ? joinShaderSources({"shared/lattice_types.glsl"}) : std::string()) +
                  (lattice ? joinShaderSources({"gpu/fetch_lattice.glsl", "shared/lattice.glsl"}) : std::string()));
  replaceOnce(lighting, "//BP::LampFree",
              binding.lampLobes ? joinShaderSources({"shared/lobe_frame.glsl", "shared/lamp_types.glsl",
                                                     "shared/lamp_fade.glsl", "gpu/lamp_free.glsl"})
                                : std::string());
  replaceOnce(lighting, "//BP::Sights",
              sights ? "#define BP_SIGHT_LIGHTS " + std::to_string(binding.sightLights.size()) + "\n" +
                           joinShaderSources({"shared/sight.glsl", "gpu/sight.glsl"})
                     : std::string());
  std::string lamps;
  if (binding.lampsDrawn()) {
    lamps = "#define BP_LAMPS " + std::to_string(ProbeBinding::kMaxLampsPerDraw) + "\n" +
            (binding.lampLobes ? std::string() : joinShaderSources({"shared/lamp_types.glsl"})) +
            joinShaderSources({"gpu/lamps.glsl"});
    replaceOnce(
        lamps, "//BP::LampLight",
        joinShaderSources(binding.lampLobes ? std::vector<std::string>{"shared/lamp.glsl", "shared/lamp_lobe.glsl"}
                                            : std::vector<std::string>{"shared/lamp.glsl"}));
  }
  replaceOnce(lighting, "//BP::Lamps", lamps);
  replaceOnce(lighting, "//BP::Openness",
              binding.sky && binding.openness ? joinShaderSources({"shared/sky_openness.glsl", "gpu/sky_openness.glsl"})
                                              : std::string());
  std::string shares(shaderSource("gpu/probe_shares.glsl"));
  replaceOnce(shares, "//BP::Weights", perSlot(shaderSource("gpu/probe_weight.glsl"), binding));
  replaceOnce(shares, "//BP::Shares", perSlot("  bpShareOf[@SLOT@] = share[@GROUP@] * weight[@SLOT@];\n", binding));
  replaceOnce(lighting, "//BP::ShareOut", shares);
  replaceOnce(lighting, "//BP::AddSlots", perSlot(shaderSource("gpu/probe_share.glsl"), binding));
  const auto define = [](const char* name, bool value) {
    return std::string("#define ") + name + (value ? " 1\n" : " 0\n");
  };
  return define("BP_ROTATED", binding.rotated()) + define("BP_WEIGHTS", binding.weights) +
         define("BP_CONSTANT_SHARES", binding.weights && !binding.shares.empty()) +
         define("BP_ONLY_PROBES", binding.onlyProbes) + define("BP_SKY", binding.sky) +
         define("BP_OPENNESS", binding.sky && binding.openness) + define("BP_DIFFUSE", binding.diffuse) +
         define("BP_LATTICE", lattice) + define("BP_LAMP_SHAPES", lattice && binding.lamps) +
         define("BP_LAMP_LOBES", binding.lampLobes) + define("BP_SIGHTS", sights) + define("BP_DEBUG", debug) +
         define("BP_SAMPLED", output == SurfaceOutput::SpecularSeparate) +
         define("BP_BLUE_NOISE", binding.blueNoise()) + define("BP_LIGHT", binding.chooses("sampling", "luminance")) +
         (mirror ? "#define BP_MIRROR\n" : "") + (binding.bevelled() ? "#define BP_BEVEL\n" : "") +
         define("BP_OCCLUSION", binding.occluded()) + "#define BP_SLOTS " + std::to_string(binding.probes.size()) +
         "\n#define BP_GROUPS " + std::to_string(groups.empty() ? 0 : groups.back() + 1) + "\n#define BP_MARCH " +
         std::to_string(marchForms(binding)) + "\n" +
         joinShaderSources({"shared/types.glsl", "shared/finite.glsl", "shared/slab.glsl", "shared/roughness.glsl",
                            "shared/weights.glsl", "shared/sh.glsl"}) +
         (flatMaps ? "#define BP_FLAT_MAPS\n" + joinShaderSources({"gpu/flat_lookup.glsl"}) : std::string()) +
         (debug ? joinShaderSources({"shared/cube.glsl", "gpu/debug_trace.glsl"}) : std::string()) + lighting;
}

std::string coverageDeclarations(const ProbeBinding& binding) {
  if (binding.shadowLights.empty()) return {};
  std::string text(shaderSource("gpu/coverage.glsl"));
  replaceOnce(
      text, "//BP::Through",
      perSlot(
          "  if (bpShareOf[@SLOT@] > 1.0e-5f)\n  {\n    through += bpShareOf[@SLOT@] *\n"
          "      ((bpShadowMask[@SLOT@] >> bit & 1) != 0 ? bpThroughSlot@SLOT@(position, toLight, tangent, perUnit) "
          ": vec3(1.0f));\n  }\n",
          binding));
  return "#define BP_SHADOW_LIGHTS " + std::to_string(binding.shadowLights.size()) + "\n" +
         joinShaderSources({"shared/coverage_types.glsl", "shared/coverage.glsl"}) +
         perSlot(shaderSource("gpu/coverage_slot.glsl"), binding) + text;
}

std::string shadowMapDeclarations(const ProbeBinding& binding) {
  std::string text;
  const auto add = [&text](const char* source, int light) {
    std::string piece(shaderSource(source));
    replaceAll(piece, "@LIGHT@", std::to_string(light));
    text += piece;
  };
  if (!binding.movingLights.empty()) text += "#define BP_MOVING_MAP_SIZE " + std::to_string(kMovingMapSize) + ".0f\n";
  for (const int light : binding.movingLights) add("gpu/moving_shadow.glsl", light);
  for (const SunUse& sun : binding.sunLights) add("gpu/sun_shadow.glsl", sun.light);
  return text;
}

}  // namespace boxprobe
