// Statements that vtkOpenGLPolyDataMapper::ReplaceShaderLight of VTK 9.1 writes, with their replacements. Newer
// versions' text is first converted to 9.1's (see vtk_text_forms.h).
#include "filters/vtk/surface/pbr_anchors.h"

namespace boxprobe {

const std::vector<Anchor>& viewAndOutputAnchors() {
  static const std::vector<Anchor> anchors = {
      {"view vector", {"vec3 V = normalize(-vertexVC.xyz);"}, {"vec3 V = bpViewVector(vertexVC.xyz);"}, false},
      // d >= a2, but rounding makes it 0 for roughness near 0 and a half vector equal to the normal: 0/0.
      {"microfacet distribution",
       {"float d = (NdH * a2 - NdH) * NdH + 1.0;"},
       {"float d = max((NdH * a2 - NdH) * NdH + 1.0, max(a2, 1.0e-12));"},
       false},
      // Occlusion concerns indirect light (glTF 2.0, section 3.9.3); VTK also darkens that of lamps.
      {"occlusion",
       {"color += Lo;\n  color = mix(color, color * ao, aoStrengthUniform);"},
       {"color = mix(color, color * ao, aoStrengthUniform);\n  color += Lo;"},
       false},
  };
  return anchors;
}

// VTK 9.1 ignores the emissive factor of a material without an emissive texture. Not corrected by default in other
// programs' properties, because VTK's default factor is white.
const std::vector<Anchor>& emissionAnchors() {
  static const std::vector<Anchor> anchors = {
      {"emission",
       {"vec3 emissiveColor = vec3(0.0);", "emissiveColor = emissiveColor * emissiveFactorUniform;"},
       {"vec3 emissiveColor = emissiveFactorUniform;", "emissiveColor = emissiveColor * emissiveFactorUniform;"},
       false},
  };
  return anchors;
}

// Textures and vertex colours of a material, sampled by our code instead of VTK's (see shaders/gpu/material.glsl).
const std::vector<Anchor>& materialAnchors() {
  static const std::vector<Anchor> anchors = {
      {"base colour",
       {"vec3 albedo = diffuseColor;"},
       {"vec4 bpBase = bpBaseColor();\n  vec3 albedo = diffuseColor * bpBase.rgb;\n  opacity = opacity * BP_ALPHA;\n"
        "  if (BP_MASKED) { discard; }"},
       false},
      {"roughness", {"float roughness = roughnessUniform;"}, {"float roughness = BP_ROUGHNESS;"}, false},
      {"metallic", {"float metallic = metallicUniform;"}, {"float metallic = BP_METALLIC;"}, false},
      {"ambient occlusion", {"float ao = 1.0;"}, {"float ao = 1.0f BP_OCCLUSION_FACTOR;"}, false},
      {"emission of the material",
       {"vec3 emissiveColor = emissiveFactorUniform;"},
       {"vec3 emissiveColor = BP_EMISSION;"},
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
       {"vec2 brdf = bpSurfaceSum(NdV, roughness);"},
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
        "  BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness, meanFresnel(bpF0, bpF90, NdV),\n"
        "    relativeF0(bpF0, bpF90));\n  vec3 irradiance = bpLight.irradiance;"},
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
        "    meanFresnel(vec3(coatF0Uniform), vec3(1.0), coatNdV), coatF0Uniform).specular;"},
       true},
  };
  return anchors;
}

// VTK 9.1 uses roughness instead of alpha in Smith's masking term for lamps.
const std::vector<Anchor>& maskingAnchors() {
  static const std::vector<Anchor> anchors = {
      {"lamps' masking",
       {"float V = V_SmithCorrelated(NdV, NdL, roughness);"},
       {"float V = V_SmithCorrelated(NdV, NdL, roughness * roughness);"},
       false},
  };
  return anchors;
}

// A clear coat's reflection is multiplied by Fresnel's term once; VTK 9.1 multiplies twice. The coat transmits the rest
// to its base; VTK dims the base too late, after summing the colour.
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

// Multiple scattering, by the same factor for surroundings and lamps.
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

// Lamps as shapes are added to the mean light of the lobe, so that all later factors apply to them as well.
const std::vector<Anchor>& lampAnchors() {
  static const std::vector<Anchor> anchors = {
      {"lamps as shapes in the reflection",
       {"vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;"},
       {"prefilteredSpecularColor += bpLampsMean(bpLight, F0, F90, brdf);\n"
        "  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;"},
       false},
      {"clear coat's light",
       {"vec3 prefilteredSpecularCoatColor = bpGatherLight("},
       {"BpLight bpCoatLight = bpGatherLight("},
       true},
      {"clear coat's mean light",
       {"meanFresnel(vec3(coatF0Uniform), vec3(1.0), coatNdV), coatF0Uniform).specular;"},
       {"meanFresnel(vec3(coatF0Uniform), vec3(1.0), coatNdV), coatF0Uniform);\n"
        "  vec3 prefilteredSpecularCoatColor = bpCoatLight.specular;"},
       true},
      {"lamps as shapes in a clear coat",
       {"vec3 coatF90 = vec3(1.0);"},
       {"vec3 coatF90 = vec3(1.0);\n"
        "  prefilteredSpecularCoatColor += bpLampsMean(bpCoatLight, coatF0, coatF90, coatBrdf);"},
       true},
  };
  return anchors;
}

// Changes for materials that transmit light, in VTK's text after the lighting's edits (see shaders/gpu/glass.glsl).
const std::vector<Anchor>& glassAnchors() {
  static const std::vector<Anchor> anchors = {
      {"glass: lookups",
       {"BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness,"},
       {"BpGlass bpGlass = bpLookThrough(vertexVC.xyz, N, V, roughness);\n  BpLight bpLight = "
        "bpGatherLight(bpGlass.position, bpGlass.normal, bpGlass.view, bpGlass.roughness,"},
       false},
      {"glass: reflectance of its facets",
       {"relativeF0(bpF0, bpF90)"},
       {"bpGlass.seen.followed ? 1.0f : relativeF0(bpF0, bpF90)"},
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
        "bpPassed * bpGlass.looked;"},
       false},
  };
  return anchors;
}

}  // namespace boxprobe
