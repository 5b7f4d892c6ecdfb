#include "filters/vtk/surface/finish_source.h"

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

namespace {

constexpr const char* kLamp = "specular = SpecularIsotropic(NdH, NdV, NdL, HdL, roughness, F0, F90, F);";
constexpr const char* kHeadlight = "specular = SpecularIsotropic(NdV, NdV, NdV, 1.0, roughness, F0, F90, F);";

}  // namespace

std::string finishSwitches(const SurfaceMaterial& surface) {
  if (!surface.finished()) return {};
  std::string text = "#define BP_FINISH\n";
  const auto define = [&text](bool there, const char* name) {
    if (there) text += std::string("#define ") + name + "\n";
  };
  define(surface.finish.tintsSpecular(), "BP_TINTED");
  define(surface.finish.hasSheen(), "BP_SHEEN");
  define(surface.finish.hasFilm(), "BP_FILM");
  if (!surface.brushed()) return text;
  // Irradiance uses the normal that the lookup's normal was bent from.
  return text +
         "#define BP_ANISOTROPIC\nvec3 bpUnbentNormal = vec3(0.0f);  // view space\nvec3 bpFacing = vec3(0.0f);\n";
}

std::string finishDeclarations(const SurfaceMaterial& surface) {
  if (!surface.finished()) return {};
  std::string text;
  const auto factor = [&](const char* macro, SurfaceSlotIndex slot, const char* value) {
    const bool there = surface.slots[slot].texture != nullptr;
    text += std::string("#define ") + macro + (there ? std::string(" * ") + value : std::string()) + "\n";
  };
  factor("BP_SPECULAR_FACTOR", kSpecularSlot, "bpSampleSpecular().a");
  factor("BP_SPECULAR_COLOR_FACTOR", kSpecularColorSlot, "bpSampleSpecularColor().rgb");
  factor("BP_SHEEN_COLOR_FACTOR", kSheenColorSlot, "bpSampleSheenColor().rgb");
  factor("BP_SHEEN_ROUGHNESS_FACTOR", kSheenRoughnessSlot, "bpSampleSheenRoughness().a");
  factor("BP_FILM_FACTOR", kIridescenceSlot, "bpSampleIridescence().r");
  text += std::string("#define BP_FILM_THICKNESS ") +
          (surface.slots[kFilmThicknessSlot].texture ? "bpSampleFilmThickness().g" : "1.0f") + "\n";
  return text +
         joinShaderSources({"shared/sheen.glsl", "shared/thin_film.glsl", "shared/anisotropy.glsl", "gpu/finish.glsl"});
}

void spliceFinish(std::string& text, const SurfaceMaterial& surface, int lamps, bool probes, bool underCoat,
                  AnchorEdits& edits) {
  if (!surface.finished()) return;
  // A light at the eye has no direction of its own; scenes without lights have a black one.
  const bool headlight = text.find(kHeadlight) != std::string::npos;
  constexpr const char* kView = "float NdV = clamp(dot(N, V), 1e-5, 1.0);";
  edits.replace(text, "finish", {{kView, std::string(kView) + "\n  BpFinish bpFinish = bpFinishAt(N, NdV);"}});
  edits.replace(text, "reflectance of the finish",
                {{"vec3 F0 = mix(vec3(baseF0Uniform), albedo, metallic);",
                  "vec3 F0 = bpFinishF0(bpFinish, albedo, metallic, NdV);"}});
  edits.replace(text, "edge of the finish",
                {{"float f90 = clamp(dot(F0, vec3(50.0 * 0.33)), 0.0, 1.0);",
                  "float f90 = bpFinishEdge(bpFinish, albedo, metallic);"}});
  if (probes) {
    edits.replace(text, "reflectance of the finish, for techniques",
                  {{"vec3 bpF0 = mix(vec3(baseF0Uniform), albedo, metallic);",
                    "vec3 bpF0 = bpFinishF0(bpFinish, albedo, metallic, NdV);"}});
    edits.replace(text, "edge of the finish, for techniques",
                  {{"mix(vec3(clamp(dot(bpF0, vec3(50.0 * 0.33)), 0.0, 1.0)), edgeTintUniform, metallic);",
                    "mix(vec3(bpFinishEdge(bpFinish, albedo, metallic)), edgeTintUniform, metallic);"}});
  }
  if (surface.brushed()) {
    if (probes) {
      edits.replace(text, "lookup of a brushed surface",
                    {{"BpLight bpLight = bpGatherLight(vertexVC.xyz, N, V, roughness,",
                      "bpUnbentNormal = N;\n  BpLight bpLight = bpGatherLight(vertexVC.xyz, "
                      "anisotropicNormal(N, V, bpFinish.across, roughness, bpFinish.anisotropy), V, roughness,"}});
    }
    const std::string own = "specular = bpBrushedLobe(bpFinish, N, V, ";
    edits.replace(
        text, "lamps on a brushed surface",
        {{kLamp, own + "L, H, HdL, roughness, F0, F90, F);"}, {kHeadlight, own + "V, V, 1.0, roughness, F0, F90, F);"}},
        lamps);
  }
  if (!surface.finish.hasSheen()) return;
  constexpr const char* kDiffuse = "diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);";
  edits.replace(
      text, "lamps on cloth",
      {{kDiffuse, std::string(kDiffuse) + "\n  diffuse = diffuse * bpFinish.under + bpFinish.sheenColor * sheenLobe(" +
                      (headlight ? "NdV, NdV, NdV" : "NdH, NdV, NdL") +
                      ", bpFinish.sheenRoughness);\n  specular *= bpFinish.under;"}},
      lamps);
  constexpr const char* kReflected = "vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;";
  edits.replace(text, "reflection under sheen",
                {{kReflected, std::string("specularBrdf *= bpFinish.under;\n  ") + kReflected}});
  constexpr const char* kSum = "vec3 color = iblDiffuse + iblSpecular;";
  edits.replace(text, "sheen",
                {{kSum, std::string("iblDiffuse = iblDiffuse * bpFinish.under + bpFinish.sheenColor * sheenAlbedo(NdV, "
                                    "bpFinish.sheenRoughness) * irradiance") +
                            (underCoat ? " * bpCoatPasses" : "") + ";\n  " + kSum}});
}

}  // namespace boxprobe
