// Tried on VTK 9.1.0 (Debian 12). The anchors are single statements that vtkOpenGLPolyDataMapper::ReplaceShaderLight
// writes; for another version, run tests/image/splice_test and correct the table below.
#include "filters/vtk/surface/vtk_pbr_splice.h"

#include <vtkVersion.h>

#include <algorithm>
#include <vector>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/surface/fragment_source.h"
#include "filters/vtk/surface/material_source.h"
#include "filters/vtk/surface/text_replace.h"

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

const std::vector<Anchor>& tableAnchors() {
  static const std::vector<Anchor> anchors = {
      {"split-sum table",
       {"vec2 brdf = vec2(0.0, 0.0);", "vec2 brdf = texture(brdfTex, vec2(NdV, roughness)).rg;"},
       {"vec2 brdf = bpSplitSum(NdV, roughness);"},
       false},
      {"clear-coat split-sum table",
       {"vec2 coatBrdf = vec2(0.0);", "vec2 coatBrdf = texture(brdfTex, vec2(coatNdV, coatRoughness)).rg;"},
       {"vec2 coatBrdf = bpSplitSum(coatNdV, coatRoughness);"},
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
        "  BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness, meanFresnel(bpF0, bpF90, NdV));\n  vec3 "
        "irradiance = bpLight.irradiance;"},
       false},
      {"specular reflection",
       {"vec3 prefilteredSpecularColor = vec3(0.0);",
        "vec3 prefilteredSpecularColor = textureLod(prefilterTex, worldReflect, roughness * prefilterMaxLevel).rgb;"},
       {"vec3 prefilteredSpecularColor = bpLight.specular;"},
       false},
      {"clear-coat reflection",
       {"vec3 prefilteredSpecularCoatColor = vec3(0.0);",
        "vec3 prefilteredSpecularCoatColor = textureLod(prefilterTex, coatWorldReflect, coatRoughness * "
        "prefilterMaxLevel).rgb;"},
       {"vec3 prefilteredSpecularCoatColor = bpGatherLight(vertexVC.xyz, coatN, V, coatRoughness,\n"
        "    meanFresnel(vec3(coatF0Uniform), vec3(1.0), coatNdV)).specular;"},
       true},
  };
  return anchors;
}

// VTK 9.1 masks lamps by roughness where Smith's term wants alpha.
const std::vector<Anchor>& maskingAnchors() {
  static const std::vector<Anchor> anchors = {
      {"lamps' masking",
       {"float V = V_SmithCorrelated(NdV, NdL, roughness);"},
       {"float V = V_SmithCorrelated(NdV, NdL, roughness * roughness);"},
       false},
  };
  return anchors;
}

// A clear coat reflects its surroundings by Fresnel's term once; VTK 9.1 multiplies by that twice. It leaves its base
// the rest; VTK dims the base too late, after it has added up the colour.
const std::vector<Anchor>& coatAnchors() {
  static const std::vector<Anchor> anchors = {
      {"base under a clear coat",
       {"vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;"},
       {"float bpCoatPasses = coatPasses(coatStrength, coatF0Uniform, coatNdV);\n"
        "  specularBrdf *= bpCoatPasses;\n  vec3 iblSpecular = prefilteredSpecularColor * "
        "specularBrdf;"},
       true},
      {"diffuse base under a clear coat",
       {"vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo;"},
       {"vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo * bpCoatPasses;"},
       true},
      {"reflection of a clear coat",
       {"prefilteredSpecularCoatColor * (coatF0 * coatBrdf.r + coatBrdf.g) * Fc;"},
       {"prefilteredSpecularCoatColor * (coatF0 * coatBrdf.r + coatBrdf.g) * coatStrength;"},
       true},
  };
  return anchors;
}

// What further reflections between microfacets bring back, of surroundings and of lamps by the same factor.
const std::vector<Anchor>& scatteringAnchors() {
  static const std::vector<Anchor> anchors = {
      {"multiple scattering",
       {"vec3 F90 = mix(vec3(f90), edgeTintUniform, metallic);"},
       {"vec3 F90 = mix(vec3(f90), edgeTintUniform, metallic);\n  vec3 bpScattering = multipleScattering(F0, brdf);"},
       false},
      {"multiple scattering of surroundings",
       {"vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;"},
       {"specularBrdf *= bpScattering;\n  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;"},
       false},
      {"multiple scattering in a clear coat",
       {"vec3 coatF90 = vec3(1.0);"},
       {"vec3 coatF90 = vec3(1.0);\n  vec3 bpCoatScattering = multipleScattering(coatF0, coatBrdf);"},
       true},
      {"multiple scattering of a clear coat's surroundings",
       {"prefilteredSpecularCoatColor * ("},
       {"prefilteredSpecularCoatColor * bpCoatScattering * ("},
       true},
  };
  return anchors;
}

// Of every lamp: as many as VTK has written in.
void scatterLamps(std::string& text) {
  replaceAll(text, "Lo += radiance * (diffuse + specular)", "Lo += radiance * (diffuse + bpScattering * specular)");
  replaceAll(text, "Lo += coatLayer;", "Lo += bpCoatScattering * coatLayer;");
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
        "metallic);\n  vec3 color = iblDiffuse * (1.0 - bpGlassTransmission BP_TRANSMISSION_FACTOR) + iblSpecular + "
        "bpPassed * "
        "bpGlass.looked;"},
       false},
  };
  return anchors;
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

std::string spliceMaterial(std::string& fragment, bool coat) {
  std::string failure = applyAnchors(fragment, materialAnchors(), coat);
  if (!failure.empty()) return failure;
  constexpr const char* kNormal = "//VTK::Normal::Impl";
  if (!replaceOnce(fragment, kNormal, std::string(shaderSource("gpu/material_normal.glsl")) + kNormal)) {
    return missing("normal", kNormal);
  }
  return {};
}

}  // namespace

std::string splicePbr(ShaderSources& sources, const ProbeBinding& binding, const SurfaceMaterial* surface,
                      SurfaceOutput writes, bool mirror, LightForm form) {
  if (sources.fragment.find(kPbrMark) == std::string::npos) return {};
  const bool coat = sources.fragment.find(kCoatMark) != std::string::npos;
  const SurfaceProgram program{binding, surface, writes, mirror, form};

  ShaderSources spliced = sources;
  std::string& text = spliced.fragment;
  if (!replaceOnce(text, kDeclarations, fragmentDeclarations(program) + "\n" + kDeclarations))
    return missing("declarations", "void main()");

  std::string failure = applyAnchors(text, viewAndOutputAnchors(), coat);
  if (failure.empty()) failure = applyFalloffs(text);
  if (failure.empty() && surface != nullptr) failure = spliceMaterial(text, coat);
  if (failure.empty() && surface != nullptr) failure = spliceVertices(spliced, *surface);
  if (failure.empty() && program.probes()) failure = applyCoverage(text, binding);
  if (failure.empty() && program.probes()) failure = applyAnchors(text, lightingAnchors(), coat);
  if (failure.empty() && program.table()) failure = applyAnchors(text, tableAnchors(), coat);
  if (failure.empty() && program.glass()) failure = applyAnchors(text, glassAnchors(), coat);
  const bool own = form != LightForm::Vtk;
  if (failure.empty() && own) failure = applyAnchors(text, maskingAnchors(), coat);
  // Lamps' share that the coat leaves to its base, as that of surroundings: shared/split_sum.glsl.
  if (own) replaceAll(text, "specular *= (1.0 - Fc) * (1.0 - Fc);", "specular *= 1.0 - Fc;");
  if (failure.empty() && own && program.probes()) failure = applyAnchors(text, coatAnchors(), coat);
  if (failure.empty() && form == LightForm::Multiple && program.table()) {
    failure = applyAnchors(text, scatteringAnchors(), coat);
    if (failure.empty()) scatterLamps(text);
  }
  if (!failure.empty()) return failure;

  constexpr const char* kOutput = "color = pow(color, vec3(1.0/2.2));";
  // VTK discards what is wholly transparent. Glass has a depth all the same, and without that test a pass for depth
  // alone need not work out a colour.
  if (program.glass()) replaceOnce(text, "if (gl_FragData[0].a <= 0.0)", "if (false)");
  // VTK 9.1 gives the colour of visible edges to ambient light alone, which its physically based shading has not, and
  // takes it from the surface's own.
  const bool edges = replaceOnce(text, "diffuseColor = mix(diffuseColor, vec3(0.0), emix);", "");
  const std::string output = fragmentOutput(program, edges ? "  color = mix(color, edgeColor, emix);\n" : "");
  if (!replaceOnce(text, kOutput, output)) {
    return missing("output", kOutput);
  }
  sources = std::move(spliced);
  return {};
}

}  // namespace boxprobe
