#include "filters/vtk/surface/vtk_text_forms.h"

namespace boxprobe {

namespace {

constexpr const char* kReflections =
    "  vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;\n"
    "  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;\n"
    "  vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo;\n";

// VTK 9.6.1 compensates the energy loss of the split sum by its own fit, or writes zero if its own image-based lighting
// is off; 9.7 formats a number differently.
std::string multiScatter(const std::string& one) {
  return "  diffuse = (1.0 - metallic) * (1.0 - 0.04) * albedo;\n"
         "  vec3 Fr = max(vec3(" +
         one +
         " - roughness), F0) - F0;\n"
         "  vec3 k_S = F0 + Fr * pow(1.0 - NdV, 5.0);\n"
         "  vec3 FssEss = k_S * brdf.r + F90 * brdf.g;\n"
         "  float Ems = 1.0 - (brdf.r + brdf.g);\n"
         "  vec3 F_avg = F0 + (1.0 - F0) / 21.0;\n"
         "  vec3 FmsEms = Ems * FssEss * F_avg / max(1.0 - F_avg * Ems, vec3(1e-5));\n"
         "  vec3 k_D = diffuse * (1.0 - FssEss - FmsEms);\n"
         "  vec3 iblSpecular = FssEss * prefilteredSpecularColor;\n"
         "  vec3 iblDiffuse = (FmsEms + k_D) * irradiance;\n";
}

// VTK 9.5 lights directional lamps by their direction also beside positional ones, and applies the falloff separately.
void normalizeLamp(std::string& fragment, const std::string& n, AnchorEdits& edits) {
  const std::string towards = "L = lightPositionVC" + n + " - vertexVC.xyz;\n";
  const std::string angles =
      "  H = normalize(V + L);\n"
      "  NdL = clamp(dot(N, L), 1e-5, 1.0);\n"
      "  NdH = clamp(dot(N, H), 1e-5, 1.0);\n"
      "  HdL = clamp(dot(H, L), 1e-5, 1.0);\n";
  edits.replaceAny(fragment, "9.5: direction of lamp " + n,
                   {{"  if (lightPositional" + n + " == 0) {\n    attenuation = 1.0;\n    L = -lightDirectionVC" + n +
                         ";\n  } else {\n    " + towards + "    distanceVC = length(L);\n    L = normalize(L);\n",
                     "  " + towards + "  distanceVC = length(L);\n  L = normalize(L);\n" + angles +
                         "  if (lightPositional" + n + " == 0)\n  {\n    attenuation = 1.0;\n  }\n  else\n  {\n"}});
  edits.replaceAny(fragment, "9.5: falloff of lamp " + n,
                   {{angles + "  radiance = lightColor" + n + ";\n  radiance *= attenuation;\n",
                     "  radiance = lightColor" + n + " * attenuation;\n"}});
}

}  // namespace

DeclaredLights declaredLights(const std::string& fragment) {
  DeclaredLights lights;
  while (fragment.find("uniform vec3 lightColor" + std::to_string(lights.count) + ";") != std::string::npos) {
    ++lights.count;
  }
  lights.positional = fragment.find("uniform int lightPositional0;") != std::string::npos;
  return lights;
}

void normalizeForms(std::string& fragment, AnchorEdits& edits) {
  edits.replaceAny(fragment, "9.3: opacity of edges",
                   {{"  diffuseColor = mix(diffuseColor, vec3(0.0), emix * edgeOpacity);\n"
                     "  ambientColor = mix( ambientColor, edgeColor, emix * edgeOpacity);\n",
                     "  emix *= edgeOpacity;\n"
                     "  diffuseColor = mix(diffuseColor, vec3(0.0), emix);\n"
                     "  ambientColor = mix( ambientColor, edgeColor, emix);\n"}});
  const DeclaredLights lights = declaredLights(fragment);
  for (int i = 0; lights.positional && i < lights.count; ++i) normalizeLamp(fragment, std::to_string(i), edits);
  edits.replaceAny(fragment, "9.6.1: multiple scattering",
                   {{multiScatter("1"), kReflections}, {multiScatter("1.0"), kReflections}});
  edits.replaceAny(fragment, "9.6.1: no surroundings",
                   {{"  vec3 iblSpecular = vec3(0.0);\n  vec3 iblDiffuse = vec3(0.0);\n", kReflections}});
  edits.replaceAny(fragment, "9.6.2: encoding after the output",
                   {{"  gl_FragData[0] = vec4(color, opacity);\n"
                     "  gl_FragData[0].rgb = pow(gl_FragData[0].rgb, vec3(1.0/2.2));\n",
                     "  color = pow(color, vec3(1.0/2.2));\n"
                     "  gl_FragData[0] = vec4(color, opacity);\n"}});
  // glTF's vertex colours are linear.
  edits.replaceAny(
      fragment, "9.7: vertex colours decoded",
      {{"  ambientColor = pow(ambientColor, vec3(2.2));\n  diffuseColor = pow(diffuseColor, vec3(2.2));\n", ""}});
}

}  // namespace boxprobe
