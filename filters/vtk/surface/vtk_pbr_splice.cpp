#include "filters/vtk/surface/vtk_pbr_splice.h"

#include <vtkVersion.h>

#include <algorithm>
#include <map>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/surface/finish_source.h"
#include "filters/vtk/surface/material_source.h"
#include "filters/vtk/surface/pbr_anchors.h"
#include "filters/vtk/surface/vtk_text_forms.h"

namespace boxprobe {

namespace {

constexpr const char* kCoatMark = "#define CLEAR_COAT";
constexpr const char* kEdgesMark = "uniform vec3 edgeColor;";
// Declared in all of VTK's physically based shaders.
constexpr const char* kPhysicalMark = "uniform float metallicUniform;";

void applyAnchors(std::string& text, const std::vector<Anchor>& anchors, bool coat, AnchorEdits& edits) {
  for (const Anchor& anchor : anchors) {
    if (anchor.coatOnly && !coat) continue;
    std::vector<AnchorEdits::Wording> wordings;
    for (std::size_t i = 0; i < anchor.texts.size(); ++i) {
      wordings.push_back({anchor.texts[i], anchor.replacements[std::min(i, anchor.replacements.size() - 1)]});
    }
    edits.replace(text, anchor.what, wordings);
  }
}

// Edits for multiple scattering and coats in every lamp's code, for the number of lamps in VTK's text.
void applyLamps(std::string& text, const SurfaceProgram& program, int lamps, bool coat, AnchorEdits& edits) {
  // The fraction of lamps' light that the coat transmits, as for surroundings: shared/split_sum.glsl.
  if (coat) {
    edits.replace(text, "lamps through a clear coat",
                  {{"specular *= (1.0 - Fc) * (1.0 - Fc);", "specular *= 1.0 - Fc;"}}, lamps);
  }
  if (program.form != LightForm::Multiple || !program.table()) return;
  edits.replace(text, "multiple scattering of lamps",
                {{"Lo += radiance * (diffuse + specular)", "Lo += radiance * (diffuse + bpScattering * specular)"}},
                lamps);
  if (coat) {
    edits.replace(text, "multiple scattering of lamps in a clear coat",
                  {{"Lo += coatLayer;", "Lo += bpCoatScattering * coatLayer;"}}, lamps);
  }
}

// If there is also a positional lamp, VTK 9.1 shades a directional one from its position; and its falloffs are not
// those of KHR_lights_punctual. scene_lights.cpp packs what they need into a vtkLight.
void applyPositional(std::string& text, int lamps, bool foreign, AnchorEdits& edits) {
  for (int i = 0; i < lamps; ++i) {
    const std::string n = std::to_string(i);
    const std::string towards = "lightPositionVC" + n + " - vertexVC.xyz;";
    edits.replace(text, "direction of a lamp",
                  {{"L = " + towards, "L = lightPositional" + n + " == 0 ? -lightDirectionVC" + n + " : " + towards}});
    if (foreign) continue;
    edits.replace(text, "distance falloff",
                  {{"attenuation = 1.0 / (lightAttenuation" + n + ".x\n      + lightAttenuation" + n +
                        ".y * distanceVC\n      + lightAttenuation" + n + ".z * distanceVC * distanceVC);",
                    "attenuation = distanceFalloff(distanceVC, lightAttenuation" + n + ".x);"}});
    edits.replace(text, "cone falloff",
                  {{"attenuation = attenuation * pow(coneDot, lightExponent" + n + ");",
                    "attenuation = attenuation * coneFalloff(coneDot, cos(radians(lightConeAngle" + n +
                        ")), lightExponent" + n + ");"}});
  }
}

/// Indices of the scene's lights in VTK's text.
struct LightPlaces {
  const std::vector<int>& places;
  int of(int light) const { return places.empty() ? light : places[static_cast<std::size_t>(light)]; }
};

// Multiplies each light by its transmittance through a probe's coverage and through shadow maps, in the lights' own
// loop, so that it applies to coats and both lobes.
void applyShadows(std::string& text, const ProbeBinding& binding, const LightPlaces& places, bool positional,
                  AnchorEdits& edits) {
  std::map<int, std::string> factors;
  bool found = false;
  for (std::size_t k = 0; k < binding.shadowLights.size(); ++k) {
    if (places.of(binding.shadowLights[k]) < 0) continue;
    const std::string n = std::to_string(binding.shadowLights[k]);
    factors[binding.shadowLights[k]] = (found ? "" : "\n  bpFindCovers(vertexVC.xyz);") +
                                       ("\n  radiance *= bpThrough(" + std::to_string(k) + ", " + n) +
                                       ", vertexVC.xyz, N, L, " + (positional ? "distanceVC" : "1.0") + ");";
    found = true;
  }
  for (const int light : binding.movingLights) {
    factors[light] += "\n  radiance *= bpMovingShadow" + std::to_string(light) + "(vertexVC.xyz);";
  }
  for (const SunUse& sun : binding.sunLights) {
    factors[sun.light] += "\n  radiance *= bpSunShadow" + std::to_string(sun.light) + "(vertexVC.xyz, N);";
  }
  for (const auto& [light, factor] : factors) {
    if (places.of(light) < 0) continue;
    const std::string radiance =
        "radiance = lightColor" + std::to_string(places.of(light)) + (positional ? " * attenuation;" : ";");
    edits.replace(text, "light's shadow", {{radiance, radiance + factor}});
  }
}

// Multiplies each light source by its visibility, if a probe's nodes do not all see it. None of these lights uses
// coverage.
void applySights(std::string& text, const ProbeBinding& binding, const LightPlaces& places, bool positional,
                 AnchorEdits& edits) {
  bool found = false;
  for (std::size_t k = 0; k < binding.sightLights.size(); ++k) {
    if (places.of(binding.sightLights[k]) < 0) continue;
    const std::string n = std::to_string(places.of(binding.sightLights[k]));
    const std::string radiance = "radiance = lightColor" + n + (positional ? " * attenuation;" : ";");
    edits.replace(text, "light's visibility",
                  {{radiance, radiance + (found ? "" : "\n  bpFindLightSights(vertexVC.xyz, N);") +
                                  "\n  radiance *= bpLightSeen(" + std::to_string(k) + ");"}});
    found = true;
  }
}

// Runs the code of VTK's last light, after all other edits, for each light of the list.
void listLights(std::string& text, int lamps, AnchorEdits& edits) {
  const std::string n = std::to_string(lamps - 1);
  const std::string start = "L = lightPositional" + n + " == 0 ?";
  edits.replace(text, "light that lends its code",
                {{start,
                  "for (int bpPlace = 0; bpPlace < bpReaching.y; ++bpPlace)\n  {\n"
                  "  BpListedLight bpListed = bpListedLight(bpPlace);\n"
                  "  vec3 lightColor" +
                      n + " = bpListed.color, lightPositionVC" + n +
                      " = bpListed.positionView;\n"
                      "  vec3 lightDirectionVC" +
                      n + " = bpListed.directionView, lightAttenuation" + n +
                      " = vec3(bpListed.perRange, 0.0, 1.0);\n"
                      "  int lightPositional" +
                      n +
                      " = bpListed.positional ? 1 : 0;\n"
                      "  float lightConeAngle" +
                      n + " = bpListed.outerDegrees, lightExponent" + n + " = bpListed.innerCosine;\n  " + start}});
  constexpr const char* kGlass = "vec3 bpReflected = vec3(bpGlassReflected(";
  edits.replace(text, "end of the lights",
                {{kGlass, std::string("}\n  ") + kGlass}, {kPbrMark, std::string("}\n  ") + kPbrMark}});
}

void spliceVertices(ShaderSources& sources, const SurfaceMaterial& surface, AnchorEdits& edits) {
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
  edits.insertAtMain(sources.vertex, "vertex attributes", declarations, "\n" + code);
  if (!edges) return;
  constexpr const char* kEmit = "gl_PrimitiveID = gl_PrimitiveIDIn;";
  edits.insertAtMain(sources.geometry, "geometry shader", geometryDeclarations);
  edits.replace(sources.geometry, "vertices of the geometry shader", {{kEmit, kEmit + ("\n" + geometryCode)}});
}

void spliceMaterial(std::string& fragment, bool coat, AnchorEdits& edits) {
  applyAnchors(fragment, materialAnchors(), coat, edits);
  constexpr const char* kNormal = "//VTK::Normal::Impl";
  edits.replace(fragment, "normal", {{kNormal, std::string(shaderSource("gpu/material_normal.glsl")) + kNormal}});
}

void spliceOutput(std::string& text, const SurfaceProgram& program, AnchorEdits& edits) {
  // VTK discards fully transparent fragments. Glass still writes depth, and without that test a depth-only pass needs
  // no colour; opaque materials get early depth tests.
  if (program.glass() || (program.facts & kNeverDiscarded) != 0) {
    edits.replace(text, "wholly transparent", {{"if (gl_FragData[0].a <= 0.0)", "if (false)"}});
  }
  // VTK 9.1 adds the colour of visible edges to ambient light, which physically based shading lacks, and takes it from
  // the surface's own colour. Edges drawn as tubes are lit, and stay unchanged.
  std::string edges;
  if (text.find(kEdgesMark) != std::string::npos) {
    constexpr const char* kFlat = "diffuseColor = mix(diffuseColor, vec3(0.0), emix);";
    constexpr const char* kTubes = "diffuseColor = mix(diffuseColor, diffuseIntensity*edgeColor, emix";
    if (text.find(kFlat) != std::string::npos) edges = "  color = mix(color, edgeColor, emix);\n";
    edits.replace(text, "colour of edges", {{kFlat, ""}, {kTubes, kTubes}});
  }
  edits.replace(text, "output", {{"color = pow(color, vec3(1.0/2.2));", fragmentOutput(program, edges)}});
}

void spliceAll(ShaderSources& sources, const SurfaceProgram& program, AnchorEdits& edits) {
  std::string& text = sources.fragment;
  const bool coat = text.find(kCoatMark) != std::string::npos;
  const DeclaredLights lights = declaredLights(text);
  // After the mapper's expanded texture declarations, before its texture coordinates.
  edits.insertAtMain(text, "declarations", fragmentDeclarations(program) + "\n");
  applyAnchors(text, viewAndOutputAnchors(), coat, edits);
  if (program.emission) applyAnchors(text, emissionAnchors(), coat, edits);
  if (lights.positional) applyPositional(text, lights.count, program.foreign, edits);
  if (program.surface != nullptr) {
    spliceMaterial(text, coat, edits);
    spliceVertices(sources, *program.surface, edits);
  }
  if (program.probes()) {
    const LightPlaces places{program.lightPlaces};
    applyShadows(text, program.binding, places, lights.positional, edits);
    applySights(text, program.binding, places, lights.positional, edits);
    applyAnchors(text, lightingAnchors(), coat, edits);
  }
  if (program.surface != nullptr) {
    const bool underCoat = coat && program.probes() && program.form != LightForm::Vtk;
    spliceFinish(text, *program.surface, lights.count, program.probes(), underCoat, edits);
  }
  if (program.table()) applyAnchors(text, tableAnchors(), coat, edits);
  if (program.probes() && program.binding.lampLobes) applyAnchors(text, lampAnchors(), coat, edits);
  if (program.glass()) {
    applyAnchors(text, glassAnchors(), coat, edits);
    // Transmitted light is not scattered, whether from lamps or surroundings.
    constexpr const char* kDiffuse = "diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);";
    edits.replace(
        text, "lamps on glass",
        {{kDiffuse, std::string(kDiffuse) + "\n  diffuse *= 1.0 - bpGlassTransmission BP_TRANSMISSION_FACTOR;"}},
        lights.count);
  }
  if (program.form != LightForm::Vtk) {
    applyAnchors(text, maskingAnchors(), coat, edits);
    if (program.probes()) applyAnchors(text, coatAnchors(), coat, edits);
    if (program.form == LightForm::Multiple && program.table()) applyAnchors(text, scatteringAnchors(), coat, edits);
    applyLamps(text, program, lights.count, coat, edits);
  }
  if (program.listsLights()) listLights(text, lights.count, edits);
  spliceOutput(text, program, edits);
}

}  // namespace

std::string spliceFailure(const AnchorEdits& edits) {
  if (edits.failure().empty()) return {};
  return std::string("VTK ") + vtkVersion::GetVTKVersion() +
         " writes a surface shader with words unknown here for: " + edits.failure() +
         "; mend filters/vtk/surface/vtk_text_forms.cpp (see tests/vtk/README.md)";
}

SpliceReport splicePbr(ShaderSources& sources, const SurfaceProgram& program, bool lit) {
  ShaderSources spliced = sources;
  AnchorEdits edits;
  normalizeForms(spliced.fragment, edits);
  SpliceReport report;
  const int marks = countOf(spliced.fragment, kPbrMark);
  report.needed = lit || marks > 0 || spliced.fragment.find(kPhysicalMark) != std::string::npos;
  if (!report.needed) return report;
  if (marks == 1) {
    spliceAll(spliced, program, edits);
  } else {
    edits.fail("physically based shading", kPbrMark, marks, 1);
  }
  report.anchors = edits.counts();
  report.failure = spliceFailure(edits);
  if (report.failure.empty()) sources = std::move(spliced);
  return report;
}

}  // namespace boxprobe
