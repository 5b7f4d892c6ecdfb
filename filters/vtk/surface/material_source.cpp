#include "filters/vtk/surface/material_source.h"

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

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
  factor("BP_TRANSMISSION_FACTOR", kTransmissionSlot, "bpSampleTransmission().r");
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

}  // namespace boxprobe
