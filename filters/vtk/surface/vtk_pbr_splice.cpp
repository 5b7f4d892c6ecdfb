// Tried on VTK 9.1.0 (Debian 12). The anchors are single statements that vtkOpenGLPolyDataMapper::ReplaceShaderLight
// writes; for another version, run tests/image/splice_test and correct the table below.
#include "filters/vtk/surface/vtk_pbr_splice.h"

#include <vtkVersion.h>

#include <algorithm>
#include <vector>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

namespace {

// In every physically based fragment shader of VTK, and in no other.
constexpr const char* kPbrMark = "vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;";
constexpr const char* kCoatMark = "#define CLEAR_COAT";

struct Anchor {
  const char* what;
  std::vector<const char*> texts;         // what VTK may have written: without and with its own image-based lighting
  std::vector<const char*> replacements;  // one for each text, or one for all
  bool coatOnly;
};

// Declarations go where the mapper's own texture declarations have been expanded, before its texture coordinates.
constexpr const char* kDeclarations = "void main()\n{";

const std::vector<Anchor>& viewAndOutputAnchors() {
  static const std::vector<Anchor> anchors = {
      {"view vector", {"vec3 V = normalize(-vertexVC.xyz);"}, {"vec3 V = bpViewVector(vertexVC.xyz);"}, false},
      // d is at least a2; rounding makes it 0 where roughness is near 0 and the half vector is the normal: 0/0.
      {"microfacet distribution",
       {"float d = (NdH * a2 - NdH) * NdH + 1.0;"},
       {"float d = max((NdH * a2 - NdH) * NdH + 1.0, max(a2, 1.0e-12));"},
       false},
      // VTK 9.1 drops the emissive factor of a material without an emissive texture.
      {"emission",
       {"vec3 emissiveColor = vec3(0.0);", "emissiveColor = emissiveColor * emissiveFactorUniform;"},
       {"vec3 emissiveColor = emissiveFactorUniform;", "emissiveColor = emissiveColor * emissiveFactorUniform;"},
       false},
      // Occlusion is of light from all around (glTF 2.0, section 3.9.3); VTK darkens that of lamps, too.
      {"occlusion",
       {"color += Lo;\n  color = mix(color, color * ao, aoStrengthUniform);"},
       {"color = mix(color, color * ao, aoStrengthUniform);\n  color += Lo;"},
       false},
  };
  return anchors;
}

// A material's textures and vertex colours, sampled here and not by VTK (see shaders/gpu/material.glsl).
const std::vector<Anchor>& materialAnchors() {
  static const std::vector<Anchor> anchors = {
      {"base colour",
       {"vec3 albedo = diffuseColor;"},
       {"vec4 bpBase = bpBaseColor();\n  vec3 albedo = diffuseColor * bpBase.rgb;\n  opacity = opacity * BP_ALPHA;\n"
        "  if (BP_MASKED) { discard; }"},
       false},
      {"roughness",
       {"float roughness = roughnessUniform;"},
       {"float roughness = roughnessUniform BP_ROUGH_FACTOR;"},
       false},
      {"metallic", {"float metallic = metallicUniform;"}, {"float metallic = metallicUniform BP_METAL_FACTOR;"}, false},
      {"ambient occlusion", {"float ao = 1.0;"}, {"float ao = 1.0f BP_OCCLUSION_FACTOR;"}, false},
      {"emission of the material",
       {"vec3 emissiveColor = emissiveFactorUniform;"},
       {"vec3 emissiveColor = emissiveFactorUniform BP_EMISSIVE_FACTOR;"},
       false},
      {"clear coat",
       {"float coatStrength = coatStrengthUniform;"},
       {"float coatStrength = coatStrengthUniform BP_COAT_FACTOR;"},
       true},
      {"clear-coat roughness",
       {"float coatRoughness = coatRoughnessUniform;"},
       {"float coatRoughness = coatRoughnessUniform BP_COAT_ROUGH_FACTOR;"},
       true},
  };
  return anchors;
}

const std::vector<Anchor>& lightingAnchors() {
  static const std::vector<Anchor> anchors = {
      {"diffuse irradiance",
       {"vec3 irradiance = vec3(0.0);", "vec3 irradiance = texture(irradianceTex, envMatrix*N).rgb;",
        "vec3 irradiance = vec3(ComputeSH(rotN, shRed), ComputeSH(rotN, shGreen), ComputeSH(rotN, shBlue));"},
       {"vec3 bpF0 = mix(vec3(baseF0Uniform), albedo, metallic);\n"
        "  vec3 bpF90 = mix(vec3(clamp(dot(bpF0, vec3(50.0 * 0.33)), 0.0, 1.0)), edgeTintUniform, metallic);\n"
        "  BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness, bpMeanFresnel(bpF0, bpF90, NdV));\n  vec3 "
        "irradiance = bpLight.irradiance;"},
       false},
      {"specular reflection",
       {"vec3 prefilteredSpecularColor = vec3(0.0);",
        "vec3 prefilteredSpecularColor = textureLod(prefilterTex, worldReflect, roughness * prefilterMaxLevel).rgb;"},
       {"vec3 prefilteredSpecularColor = bpLight.specular;"},
       false},
      {"split-sum table",
       {"vec2 brdf = vec2(0.0, 0.0);", "vec2 brdf = texture(brdfTex, vec2(NdV, roughness)).rg;"},
       {"vec2 brdf = texture(bpBrdf, vec2(NdV, roughness)).rg;"},
       false},
      {"clear-coat reflection",
       {"vec3 prefilteredSpecularCoatColor = vec3(0.0);",
        "vec3 prefilteredSpecularCoatColor = textureLod(prefilterTex, coatWorldReflect, coatRoughness * "
        "prefilterMaxLevel).rgb;"},
       {"vec3 prefilteredSpecularCoatColor = bpGatherLight(vertexVC.xyz, coatN, V, coatRoughness,\n"
        "    bpMeanFresnel(vec3(coatF0Uniform), vec3(1.0), coatNdV)).specular;"},
       true},
      {"clear-coat split-sum table",
       {"vec2 coatBrdf = vec2(0.0);", "vec2 coatBrdf = texture(brdfTex, vec2(coatNdV, coatRoughness)).rg;"},
       {"vec2 coatBrdf = texture(bpBrdf, vec2(coatNdV, coatRoughness)).rg;"},
       true},
  };
  return anchors;
}

// What a material that transmits light changes, in VTK's text with the lighting above in it (see
// shaders/gpu/glass.glsl).
const std::vector<Anchor>& glassAnchors() {
  static const std::vector<Anchor> anchors = {
      {"glass: lookups",
       {"BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness,"},
       {"BpGlass bpGlass = bpLookThrough(vertexVC.xyz, N, V, roughness);\n  BpLight bpLight = "
        "bpGatherLight(bpGlass.position, bpGlass.normal, bpGlass.view, bpGlass.roughness,"},
       false},
      {"glass: reflectance",
       {kPbrMark},
       {"vec3 bpReflected = vec3(bpGlassReflected(bpGlass, brdf));\n  vec3 specularBrdf = "
        "mix(bpReflected * bpGlass.mirrorTransmittance, F0 * brdf.r + F90 * brdf.g, metallic);"},
       false},
      {"glass: light from beyond",
       {"vec3 color = iblDiffuse + iblSpecular;"},
       {"bpGlass.looked = bpLookUpThrough(bpGlass);\n  vec3 bpPassed = bpGlassPassed(bpGlass, bpReflected, albedo, "
        "metallic);\n  vec3 color = iblDiffuse * (1.0 - bpGlassTransmission) + iblSpecular + bpPassed * "
        "bpGlass.looked;"},
       false},
  };
  return anchors;
}

bool replaceOnce(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return false;
  text.replace(at, from.size(), to);
  return true;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string missing(const std::string& what, const std::string& anchor) {
  return std::string("VTK ") + vtkVersion::GetVTKVersion() + " writes a shader without the anchor for the " + what +
         ": \"" + anchor + "\"; Boxprobe is known to work with VTK 9.1.0";
}

std::string applyAnchors(std::string& text, const std::vector<Anchor>& anchors, bool coat) {
  for (const Anchor& anchor : anchors) {
    if (anchor.coatOnly && !coat) continue;
    bool found = false;
    for (std::size_t i = 0; i < anchor.texts.size() && !found; ++i) {
      found = replaceOnce(text, anchor.texts[i], anchor.replacements[std::min(i, anchor.replacements.size() - 1)]);
    }
    if (!found) return missing(anchor.what, anchor.texts.front());
  }
  return {};
}

// VTK's falloffs in place of those of KHR_lights_punctual; scene_lights.cpp packs what they need into a vtkLight.
std::string applyFalloffs(std::string& text) {
  for (int i = 0; text.find("uniform float lightConeAngle" + std::to_string(i) + ";") != std::string::npos; ++i) {
    const std::string n = std::to_string(i);
    const std::string distance = "attenuation = 1.0 / (lightAttenuation" + n + ".x\n      + lightAttenuation" + n +
                                 ".y * distanceVC\n      + lightAttenuation" + n + ".z * distanceVC * distanceVC);";
    if (!replaceOnce(text, distance, "attenuation = distanceFalloff(distanceVC, lightAttenuation" + n + ".x);")) {
      return missing("distance falloff", distance);
    }
    const std::string cone = "attenuation = attenuation * pow(coneDot, lightExponent" + n + ");";
    if (!replaceOnce(text, cone,
                     "attenuation = attenuation * coneFalloff(coneDot, cos(radians(lightConeAngle" + n +
                         ")), lightExponent" + n + ");")) {
      return missing("cone falloff", cone);
    }
  }
  return {};
}

// Each light that a probe's coverage stands before, times what it lets through: in the lights' own loop, so that coats
// and both lobes have it alike.
std::string applyCoverage(std::string& text, const ProbeBinding& binding) {
  for (std::size_t k = 0; k < binding.shadowLights.size(); ++k) {
    const std::string n = std::to_string(binding.shadowLights[k]);
    const std::string positional = "radiance = lightColor" + n + " * attenuation;";
    const std::string directional = "radiance = lightColor" + n + ";";
    const bool far = text.find(positional) == std::string::npos;
    const auto& moving = binding.movingLights;
    const bool moves = std::find(moving.begin(), moving.end(), binding.shadowLights[k]) != moving.end();
    const std::string& anchor = far ? directional : positional;
    const std::string through = anchor + (k == 0 ? "\n  bpFindCovers(vertexVC.xyz);" : "") +
                                "\n  radiance *= bpThrough(" + std::to_string(k) + ", " + n + ", vertexVC.xyz, N, L, " +
                                (far ? "1.0" : "distanceVC") + ")" +
                                (moves ? " * bpMovingShadow" + n + "(vertexVC.xyz)" : "") + ";";
    if (!replaceOnce(text, anchor, through)) return missing("light's shadow", anchor);
  }
  return {};
}

// One varying from the vertices to the fragments: "bpUv0" is the attribute, bpUv0F what the fragment reads.
struct Varying {
  const char* type;
  const char* name;
  const char* value;  // in the vertex shader
};

std::vector<Varying> varyings(const SurfaceMaterial& surface) {
  std::vector<Varying> list;
  if (surface.uv[0]) list.push_back({"vec2", "bpUv0", "bpUv0"});
  if (surface.uv[1]) list.push_back({"vec2", "bpUv1", "bpUv1"});
  if (surface.colors) list.push_back({"vec4", "bpColor", "bpColor"});
  // Normals go by the inverse transpose, tangents along with the surface.
  if (surface.tangents)
    list.push_back({"vec4", "bpTangent", "vec4(transpose(inverse(normalMatrix)) * bpTangent.xyz, bpTangent.w)"});
  return list;
}

std::string spliceVertices(ShaderSources& sources, const SurfaceMaterial& surface) {
  const bool edges = !sources.geometry.empty();
  const std::string out = edges ? "V" : "F";
  std::string declarations, code, geometryDeclarations, geometryCode;
  for (const Varying& v : varyings(surface)) {
    const std::string type = v.type, name = v.name;
    declarations += "in " + type + " " + name + ";\nout " + type + " " + name + out + ";\n";
    code += "  " + name + out + " = " + v.value + ";\n";
    geometryDeclarations += "in " + type + " " + name + "V[];\nout " + type + " " + name + "F;\n";
    geometryCode += "  " + name + "F = " + name + "V[i];\n";
  }
  if (!replaceOnce(sources.vertex, kDeclarations, declarations + kDeclarations + "\n" + code)) {
    return missing("vertex attributes", "void main()");
  }
  if (!edges) return {};
  constexpr const char* kEmit = "gl_PrimitiveID = gl_PrimitiveIDIn;";
  if (!replaceOnce(sources.geometry, kDeclarations, geometryDeclarations + kDeclarations) ||
      !replaceOnce(sources.geometry, kEmit, kEmit + ("\n" + geometryCode))) {
    return missing("geometry shader", kEmit);
  }
  return {};
}

std::string materialDeclarations(const SurfaceMaterial& surface) {
  std::string text;
  for (const Varying& v : varyings(surface)) text += std::string("in ") + v.type + " " + v.name + "F;\n";
  for (std::size_t i = 0; i < surface.slots.size(); ++i) {
    const SurfaceSlot& slot = surface.slots[i];
    if (!slot.texture) continue;
    const std::string name = surfaceSlotNames()[i];
    text += "#define BP_HAS_" + name + "\nuniform sampler2D bpTex" + name + ";\nuniform vec3 bpUv" + name +
            "[2];\nvec4 bpSample" + name + "()\n{\n  vec3 uv = vec3(bpUv" + std::to_string(slot.uvSet) +
            "F, 1.0f);\n  return texture(bpTex" + name + ", vec2(dot(bpUv" + name + "[0], uv), dot(bpUv" + name +
            "[1], uv)));\n}\n";
  }
  const auto factor = [&](const char* macro, SurfaceSlotIndex slot, const std::string& value) {
    text += std::string("#define ") + macro + (surface.slots[slot].texture ? " * " + value : "") + "\n";
  };
  factor("BP_ROUGH_FACTOR", kRoughMetalSlot, "bpSampleRoughMetal().g");
  factor("BP_METAL_FACTOR", kRoughMetalSlot, "bpSampleRoughMetal().b");
  factor("BP_OCCLUSION_FACTOR", kOcclusionSlot, "bpSampleOcclusion().r");
  factor("BP_COAT_FACTOR", kCoatSlot, "bpSampleCoat().r");
  factor("BP_COAT_ROUGH_FACTOR", kCoatRoughnessSlot, "bpSampleCoatRoughness().g");
  if (surface.unlit) {
    text += "#define BP_EMISSIVE_FACTOR * bpBase.rgb\n";
  } else {
    factor("BP_EMISSIVE_FACTOR", kEmissiveSlot, "bpSampleEmissive().rgb");
  }
  text += std::string("#define BP_ALPHA ") + (surface.alphaMode == AlphaMode::Blend ? "bpBase.a" : "1.0f") + "\n";
  text += std::string("#define BP_MASKED ") +
          (surface.alphaMode == AlphaMode::Mask ? "bpBase.a < bpAlphaCutoff" : "false") + "\n";
  text += std::string("#define BP_COLOR ") + (surface.colors ? "1\n" : "0\n");
  text += std::string("#define BP_TANGENT ") + (surface.tangents ? "1\n" : "0\n");
  return text + "uniform float bpNormalScale;\nuniform float bpCoatNormalScale;\n" +
         std::string(shaderSource("gpu/material.glsl"));
}

std::string spliceMaterial(std::string& fragment, bool coat) {
  std::string failure = applyAnchors(fragment, materialAnchors(), coat);
  if (!failure.empty()) return failure;
  constexpr const char* kNormal = "//VTK::Normal::Impl";
  if (!replaceOnce(fragment, kNormal, std::string(shaderSource("gpu/material_normal.glsl")) + kNormal)) {
    return missing("normal", kNormal);
  }
  return {};
}

std::string parameterDeclarations(const ProbeBinding& binding) {
  std::string text;
  for (const ParameterRow* row : binding.parameters()) {
    if (row->number != nullptr) text += "uniform float " + parameterUniform(*row) + "[BP_SLOTS];\n";
  }
  return text;
}

// What a slot's technique reads: numbers from uniforms, choices as constants, so that the compiler drops the code of
// those not chosen.
std::string parameterAssignments(const ProbeBinding& binding, std::size_t slot) {
  const DrawnProbe& probe = *binding.probes[slot];
  std::string text;
  for (const ParameterRow* row : parametersOf(binding.technique(slot))) {
    if (row->number == nullptr && row->choice == nullptr) continue;  // of the picture, not of the lookup
    const std::string value = row->choice != nullptr ? std::to_string(probe.geometry.parameters.*row->choice)
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
               byLookup
                   ? "  bpOpenFrom = point.position;\n  bpOpenAlpha = roughness * roughness;\n  bpOpenHere = true;\n"
                     "  vec3 specular = @EVALUATE@(bpMap@SLOT@, probe, point).rgb;\n  bpOpenHere = false;\n"
               : open ? "  vec4 local = @EVALUATE@(bpMap@SLOT@, probe, point);\n  vec3 specular = local.rgb;\n"
                      : "  vec3 specular = @EVALUATE@(bpMap@SLOT@, probe, point).rgb;\n");
    replaceAll(piece, "@OPEN_SKY@", open && !byLookup ? std::string(shaderSource("gpu/open_sky.glsl")) : std::string());
    replaceAll(piece, "@SLOT@", std::to_string(slot));
    replaceAll(piece, "@GROUP@", std::to_string(groups[slot]));
    const ProbeGeometry& geometry = binding.probes[slot]->geometry;
    const std::string index = "[" + std::to_string(slot) + "]";
    replaceAll(piece, "@BEVEL@",
               geometry.bevelled ? "bpBevel" + index + ".x + bpBevel" + index + ".y * roughness" : "0.0f");
    replaceAll(piece, "@OCCLUDED@", geometry.occluded ? "1" : "0");
    replaceAll(piece, "@PROJECTION@", std::to_string(technique.projection));
    replaceAll(piece, "@EVALUATE@",
               std::string(evaluationRows()[static_cast<std::size_t>(technique.evaluation)].function));
    replaceAll(piece, "@SMOOTHED@", binding.blurred(slot) ? "1.0f" : "0.0f");
    replaceAll(piece, "@PARAMETERS@", parameterAssignments(binding, slot));
    text += piece;
  }
  return text;
}

// The files and the dispatch that this draw's techniques need, and no other.
std::string techniqueSources(const ProbeBinding& binding, bool debug) {
  std::vector<std::string> projectionFiles, evaluationFiles, dispatched;
  // Two may build on the same file, and the debug view's own code on it, too.
  std::set<std::string_view> present;
  if (debug) present.insert("shared/cube.glsl");
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
  if (binding.probes.empty()) return {};
  const auto& first = projectionRows()[static_cast<std::size_t>(binding.technique(0).projection)];
  return (binding.bevelled() ? joinShaderSources({"shared/rounded_box.glsl"}) : std::string()) +
         (binding.occluded() ? joinShaderSources({"shared/box_occlusion.glsl"}) : std::string()) +
         joinShaderSources(projectionFiles) +
         "ProbeHit projectRay(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n{\n" + dispatch +
         "  return " + std::string(first.function) +
         "(probe, position, normal, reflection);\n}\n#define PROBE_MAP samplerCube\n#define DISTANCE_MAP "
         "samplerCube\n" +
         (debug ? joinShaderSources({"gpu/debug_distance.glsl", "shared/true_hit.glsl"}) : std::string()) +
         (openByLookup ? joinShaderSources({"shared/open_lookup.glsl", "gpu/fetch_probe_open.glsl"})
                       : joinShaderSources({"gpu/fetch_probe.glsl"})) +
         joinShaderSources({"gpu/fetch_blue_noise.glsl", "gpu/fetch_light.glsl", "shared/level_curve.glsl"}) +
         joinShaderSources(evaluationFiles);
}

std::string glassDeclarations(const GlassSurface& glass) {
  const bool followed = glass.form == GlassForm::TwoInterface && !glass.sheet;
  return "#define BP_GLASS\n#define BP_GLASS_FORM " + std::to_string(static_cast<int>(glass.form)) +
         "\n#define BP_GLASS_SHEET " + (glass.sheet ? "1" : "0") +
         (followed
              ? "\n#define GLASS_SHELL samplerCube\nvec4 fetchGlassShell(samplerCube shell, vec3 direction) { return "
                "textureLod(shell, direction, 0.0f); }\n"
              : "\n#define GLASS_SHELL int\nvec4 fetchGlassShell(int shell, vec3 direction) { return vec4(0.0f); }\n") +
         joinShaderSources({"shared/glass_types.glsl", "shared/refraction.glsl", "gpu/glass.glsl"});
}

std::string probeDeclarations(const ProbeBinding& binding, SurfaceOutput output, bool mirror) {
  const bool debug = output == SurfaceOutput::Debug;
  const std::vector<int> groups = binding.groups();
  std::string lighting(shaderSource("gpu/probe_lighting.glsl"));
  std::string samplers;
  for (std::size_t slot = 0; debug && slot < binding.probes.size(); ++slot) {
    samplers += "uniform samplerCube bpDistanceMap" + std::to_string(slot) + ";\n";
  }
  if (binding.distances()) samplers += joinShaderSources({"shared/relief.glsl", "gpu/fetch_relief.glsl"});
  // A scene without planar mirrors compiles none of it.
  if (mirror) {
    samplers += "#define MIRROR_PICTURE int\n" +
                joinShaderSources({"shared/mirror_types.glsl", "gpu/mirror_picture.glsl", "shared/planar_mirror.glsl"});
  }
  replaceOnce(lighting, "//BP::Distances", samplers);
  replaceOnce(lighting, "//BP::Slots",
              techniqueSources(binding, debug) + parameterDeclarations(binding) +
                  perSlot(shaderSource("gpu/probe_slot.glsl"), binding));
  replaceOnce(lighting, "//BP::Weights", perSlot(shaderSource("gpu/probe_weight.glsl"), binding));
  replaceOnce(lighting, "//BP::ConstantShares", perSlot(shaderSource("gpu/probe_share.glsl"), binding));
  replaceOnce(lighting, "//BP::Shares", perSlot(shaderSource("gpu/probe_share.glsl"), binding));
  const auto define = [](const char* name, bool value) {
    return std::string("#define ") + name + (value ? " 1\n" : " 0\n");
  };
  return define("BP_ROTATED", binding.rotated()) + define("BP_WEIGHTS", binding.weights) +
         define("BP_CONSTANT_SHARES", binding.weights && !binding.shares.empty()) +
         define("BP_ONLY_PROBES", binding.onlyProbes) + define("BP_SKY", binding.sky) +
         define("BP_DIFFUSE", binding.diffuse) + define("BP_DEBUG", debug) +
         define("BP_SAMPLED", output == SurfaceOutput::SpecularSeparate) +
         define("BP_BLUE_NOISE", binding.chooses("pattern", "blue")) +
         define("BP_LIGHT", binding.chooses("sampling", "luminance")) + (mirror ? "#define BP_MIRROR\n" : "") +
         (binding.bevelled() ? "#define BP_BEVEL\n" : "") + define("BP_OCCLUSION", binding.occluded()) +
         "#define BP_SLOTS " + std::to_string(binding.probes.size()) + "\n#define BP_GROUPS " +
         std::to_string(groups.empty() ? 0 : groups.back() + 1) + "\n" +
         joinShaderSources({"shared/types.glsl", "shared/finite.glsl", "shared/slab.glsl", "shared/roughness.glsl",
                            "shared/weights.glsl", "shared/sh.glsl"}) +
         (debug ? joinShaderSources({"shared/cube.glsl", "gpu/debug_trace.glsl"}) : std::string()) + lighting;
}

// What applyCoverage calls.
std::string coverageDeclarations(const ProbeBinding& binding) {
  if (binding.shadowLights.empty()) return {};
  std::string text(shaderSource("gpu/coverage.glsl"));
  replaceOnce(text, "//BP::Weights", perSlot(shaderSource("gpu/probe_weight.glsl"), binding));
  replaceOnce(text, "//BP::Covers", perSlot("  bpCovers[@SLOT@] = groupShare[@GROUP@] * weight[@SLOT@];\n", binding));
  replaceOnce(
      text, "//BP::Through",
      perSlot(
          "  if (bpCovers[@SLOT@] > 1.0e-5f)\n  {\n    through += bpCovers[@SLOT@] *\n"
          "      ((bpShadowMask[@SLOT@] >> bit & 1) != 0 ? bpThroughSlot@SLOT@(position, toLight, tangent, perUnit) "
          ": vec3(1.0f));\n  }\n",
          binding));
  std::string moving;
  for (const int light : binding.movingLights) {
    std::string piece(shaderSource("gpu/moving_shadow.glsl"));
    replaceAll(piece, "@LIGHT@", std::to_string(light));
    moving += piece;
  }
  return "#define BP_SHADOW_LIGHTS " + std::to_string(binding.shadowLights.size()) + "\n#define BP_MOVING_MAP_SIZE " +
         std::to_string(kMovingMapSize) + ".0f\n" + joinShaderSources({"shared/coverage.glsl"}) +
         perSlot(shaderSource("gpu/coverage_slot.glsl"), binding) + text + moving;
}

}  // namespace

std::string parameterUniform(const ParameterRow& row) {
  return "bp_" + std::string(row.name);
}

std::string splicePbr(ShaderSources& sources, const ProbeBinding& binding, const SurfaceMaterial* surface,
                      SurfaceOutput writes, bool mirror) {
  if (sources.fragment.find(kPbrMark) == std::string::npos) return {};
  const bool coat = sources.fragment.find(kCoatMark) != std::string::npos;
  const bool probes = binding.lighting == Lighting::Probes;
  const bool unlit = binding.lighting == Lighting::Unlit;
  const bool debug = writes == SurfaceOutput::Debug;
  const bool glass = probes && surface != nullptr && surface->glass.drawn;

  ShaderSources spliced = sources;
  std::string& text = spliced.fragment;
  std::string declarations =
      probes ? probeDeclarations(binding, writes, mirror) : std::string(shaderSource("gpu/output_uniforms.glsl"));
  if (probes) declarations += coverageDeclarations(binding);
  declarations += joinShaderSources({"gpu/output.glsl", "shared/light_falloff.glsl"});
  if (surface != nullptr) declarations += materialDeclarations(*surface);
  if (glass) declarations += glassDeclarations(surface->glass);
  if (writes == SurfaceOutput::Heights) declarations += "uniform vec4 bpHeightPlane;\n";
  if (debug) {
    if (!probes) declarations += "uniform mat3 bpViewToWorld;\nuniform int bpView;\n";
    declarations += std::string("#define BP_LIT ") + (probes ? "1\n" : "0\n");
    declarations += shaderSource("gpu/surface_view.glsl");
  }
  if (!replaceOnce(text, kDeclarations, declarations + "\n" + kDeclarations))
    return missing("declarations", "void main()");

  std::string failure = applyAnchors(text, viewAndOutputAnchors(), coat);
  if (failure.empty()) failure = applyFalloffs(text);
  if (failure.empty() && surface != nullptr) failure = spliceMaterial(text, coat);
  if (failure.empty() && surface != nullptr) failure = spliceVertices(spliced, *surface);
  if (failure.empty() && probes) failure = applyCoverage(text, binding);
  if (failure.empty() && probes) failure = applyAnchors(text, lightingAnchors(), coat);
  if (failure.empty() && glass) failure = applyAnchors(text, glassAnchors(), coat);
  if (!failure.empty()) return failure;

  constexpr const char* kOutput = "color = pow(color, vec3(1.0/2.2));";
  std::string output = unlit ? "color = emissiveColor;\n" : "";
  // Explained as it is, not mixed with what lies behind it.
  if (glass && !debug) output += shaderSource("gpu/glass_output.glsl");
  // VTK discards what is wholly transparent. Glass has a depth all the same, and without that test a pass for depth
  // alone need not work out a colour.
  if (glass) replaceOnce(text, "if (gl_FragData[0].a <= 0.0)", "if (false)");
  output += debug ? "color = bpViewColor(color);\n" : "color = bpOutput(color);\n";
  // VTK 9.1 gives the colour of visible edges to ambient light alone, which its physically based shading has not, and
  // takes it from the surface's own.
  if (replaceOnce(text, "diffuseColor = mix(diffuseColor, vec3(0.0), emix);", "")) {
    output += "  color = mix(color, edgeColor, emix);\n";
  }
  if (debug) output += shaderSource("gpu/surface_output.glsl");
  if (writes == SurfaceOutput::Heights) output += shaderSource("gpu/mirrored_output.glsl");
  if (writes == SurfaceOutput::SpecularSeparate || writes == SurfaceOutput::SpecularSeparateNone) {
    // A surface without probes has nothing to keep apart, whatever it was asked.
    const bool sampled = probes && writes == SurfaceOutput::SpecularSeparate;
    output += std::string("#define BP_APART ") + (sampled ? "1\n" : "2\n");
    output += shaderSource("gpu/reflection_apart.glsl");
  }
  if (!replaceOnce(text, kOutput, output)) {
    return missing("output", kOutput);
  }
  sources = std::move(spliced);
  return {};
}

}  // namespace boxprobe
