#include "filters/vtk/surface/material_source.h"

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

std::vector<Varying> varyings(const SurfaceMaterial& surface) {
  std::vector<Varying> list;
  if (surface.uv[0]) list.push_back({"vec2", "bpUv0", "bpUv0"});
  if (surface.uv[1]) list.push_back({"vec2", "bpUv1", "bpUv1"});
  if (surface.colors) list.push_back({"vec4", "bpColor", "bpColor"});
  // Normals use the inverse transpose, tangents the model matrix.
  if (surface.tangents)
    list.push_back({"vec4", "bpTangent", "vec4(transpose(inverse(normalMatrix)) * bpTangent.xyz, bpTangent.w)"});
  return list;
}

namespace {

// The slot whose texture is sampled instead.
int lookedUpFor(std::size_t slot, SurfaceFacts facts) {
  if (slot == kEmissiveSlot && (facts & kEmissionIsBase) != 0) return kBaseColorSlot;
  if (slot == kOcclusionSlot && (facts & kOcclusionInRoughMetal) != 0) return kRoughMetalSlot;
  return static_cast<int>(slot);
}

std::string samplingFunction(const std::string& name, const SurfaceSlot& slot, bool plain) {
  const std::string set = "bpUv" + std::to_string(slot.uvSet) + "F";
  std::string text = "uniform sampler2D bpTex" + name + ";\n";
  if (!plain) text += "uniform vec3 bpUv" + name + "[2];\n";
  text += "vec4 bpSample" + name + "()\n{\n";
  if (plain) return text + "  return texture(bpTex" + name + ", " + set + ");\n}\n";
  return text + "  vec3 uv = vec3(" + set + ", 1.0f);\n  return texture(bpTex" + name + ", vec2(dot(bpUv" + name +
         "[0], uv), dot(bpUv" + name + "[1], uv)));\n}\n";
}

}  // namespace

std::string materialDeclarations(const SurfaceMaterial& surface, SurfaceFacts facts) {
  const auto holds = [facts](SurfaceFact fact) { return (facts & fact) != 0; };
  std::string text;
  for (const Varying& v : varyings(surface)) text += std::string("in ") + v.type + " " + v.name + "F;\n";
  for (std::size_t i = 0; i < surface.slots.size(); ++i) {
    const SurfaceSlot& slot = surface.slots[i];
    if (!slot.texture) continue;
    const std::string name = surfaceSlotNames()[i];
    const int lookedUp = lookedUpFor(i, facts);
    text += "#define BP_HAS_" + name + "\n";
    text += lookedUp == static_cast<int>(i) ? samplingFunction(name, slot, holds(kPlainUv))
                                            : "#define bpSample" + name + " bpSample" +
                                                  surfaceSlotNames()[static_cast<std::size_t>(lookedUp)] + "\n";
  }
  const auto times = [&](SurfaceSlotIndex slot, const char* value) {
    return surface.slots[slot].texture ? std::string(" * ") + value : std::string();
  };
  const auto define = [&text](const char* macro, const std::string& value) {
    text += std::string("#define ") + macro + " " + value + "\n";
  };
  const auto factor = [&](const char* macro, SurfaceSlotIndex slot, const char* value) {
    define(macro, times(slot, value));
  };
  define("BP_ROUGHNESS",
         holds(kSmooth) ? "0.0f" : "roughnessUniform" + times(kRoughMetalSlot, "bpSampleRoughMetal().g"));
  define("BP_METALLIC", holds(kNoMetal)    ? "0.0f"
                        : holds(kAllMetal) ? "1.0f"
                                           : "metallicUniform" + times(kRoughMetalSlot, "bpSampleRoughMetal().b"));
  define("BP_EMISSION", surface.unlit ? "emissiveFactorUniform * bpBase.rgb"
                        : holds(kNoEmission)
                            ? "vec3(0.0f)"
                            : "emissiveFactorUniform" + times(kEmissiveSlot, "bpSampleEmissive().rgb"));
  factor("BP_OCCLUSION_FACTOR", kOcclusionSlot, "bpSampleOcclusion().r");
  factor("BP_COAT_FACTOR", kCoatSlot, "bpSampleCoat().r");
  factor("BP_COAT_ROUGH_FACTOR", kCoatRoughnessSlot, "bpSampleCoatRoughness().g");
  factor("BP_THICKNESS_FACTOR", kThicknessSlot, "bpThicknessScale * bpSampleThickness().g");
  if (surface.slots[kThicknessSlot].texture) text += "uniform float bpThicknessScale;\n";
  factor("BP_TRANSMISSION_FACTOR", kTransmissionSlot, "bpSampleTransmission().r");
  text += std::string("#define BP_ALPHA ") + (surface.alphaMode == AlphaMode::Blend ? "bpBase.a" : "1.0f") + "\n";
  text += std::string("#define BP_MASKED ") +
          (surface.alphaMode == AlphaMode::Mask ? "bpBase.a < bpAlphaCutoff" : "false") + "\n";
  text += std::string("#define BP_COLOR ") + (surface.colors ? "1\n" : "0\n");
  text += std::string("#define BP_TANGENT ") + (surface.tangents ? "1\n" : "0\n");
  return text + "uniform float bpNormalScale;\nuniform float bpCoatNormalScale;\n" +
         std::string(shaderSource("gpu/material.glsl"));
}

std::string glassDeclarations(const GlassSurface& glass) {
  const bool followed = glass.form == GlassForm::TwoInterface && !glass.sheet;
  return "#define BP_GLASS\n#define BP_GLASS_FORM " + std::to_string(static_cast<int>(glass.form)) +
         "\n#define BP_GLASS_SHEET " + (glass.sheet ? "1" : "0") +
         (followed
              ? "\n#define GLASS_SHELL samplerCube\nvec4 fetchGlassShell(samplerCube shell, vec3 direction) { return "
                "textureLod(shell, direction, 0.0f); }\n"
              : "\n#define GLASS_SHELL int\nvec4 fetchGlassShell(int shell, vec3 direction) { return vec4(0.0f); }\n") +
         joinShaderSources(
             {"shared/glass_types.glsl", "shared/refraction.glsl", "gpu/glass_behind.glsl", "gpu/glass.glsl"});
}

}  // namespace boxprobe
