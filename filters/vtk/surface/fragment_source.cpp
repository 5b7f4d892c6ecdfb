#include "filters/vtk/surface/fragment_source.h"

#include "filters/math/sampling/brdf_table.h"
#include "filters/math/shared/shader_source.h"
#include "filters/vtk/draw/display_source.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/surface/finish_source.h"
#include "filters/vtk/surface/material_source.h"
#include "filters/vtk/surface/probe_source.h"

namespace boxprobe {

std::string fragmentDeclarations(const SurfaceProgram& program) {
  const bool probes = program.probes();
  std::string text;
  if (program.table()) {
    text += "#define BP_BRDF_SIZE " + std::to_string(kBrdfTableSize) + ".0f\n";
    if (program.form == LightForm::Vtk) text += "#define BP_VTK_TABLE\n";
    if ((program.facts & kSmooth) != 0) text += "#define BP_SMOOTH\n";
    text += joinShaderSources({"shared/fresnel.glsl", "shared/split_sum.glsl", "gpu/fetch_split_sum.glsl"});
  }
  if (program.surface != nullptr) text += finishSwitches(*program.surface);
  text += probes ? probeDeclarations(program.binding, program.output, program.mirror, program.flatMaps)
                 : std::string(shaderSource("gpu/output_uniforms.glsl"));
  if (probes) text += coverageDeclarations(program.binding) + shadowMapDeclarations(program.binding);
  // Surfaces without probes are compared with VTK's own pictures, bit for bit.
  const bool quick = (program.facts & kQuickOutput) != 0 && program.binding.lighting != Lighting::Plain;
  text += displaySource(program.tone, quick) + joinShaderSources({"shared/light_falloff.glsl"});
  if (program.surface != nullptr) {
    text += materialDeclarations(*program.surface, program.facts) + finishDeclarations(*program.surface);
  }
  if (program.listsLights()) text += shaderSource("gpu/light_list.glsl");
  if (program.glass()) text += glassDeclarations(program.surface->glass);
  if (program.output == SurfaceOutput::Heights) text += "uniform vec4 bpHeightPlane;\n";
  if (program.debug()) {
    if (!probes) text += "uniform mat3 bpViewToWorld;\nuniform int bpView;\n";
    text += std::string("#define BP_LIT ") + (probes ? "1\n" : "0\n");
    text += shaderSource("gpu/surface_view.glsl");
  }
  return text;
}

std::string fragmentOutput(const SurfaceProgram& program, const std::string& edges) {
  std::string text = program.binding.lighting == Lighting::Unlit ? "color = emissiveColor;\n" : "";
  // Explained by itself, not blended with what is behind.
  if (program.glass() && !program.debug()) text += shaderSource("gpu/glass_output.glsl");
  text += program.debug() ? "color = bpViewColor(color);\n" : "color = bpOutput(color);\n";
  text += edges;
  if (program.debug()) text += shaderSource("gpu/surface_output.glsl");
  if (program.output == SurfaceOutput::Heights) text += shaderSource("gpu/mirrored_output.glsl");
  if (program.output == SurfaceOutput::SpecularSeparate || program.output == SurfaceOutput::SpecularSeparateNone) {
    // A surface without probes has no reflection to separate, even if requested.
    const bool sampled = program.probes() && program.output == SurfaceOutput::SpecularSeparate;
    text += std::string("#define BP_APART ") + (sampled ? "1\n" : "2\n");
    text += shaderSource("gpu/reflection_apart.glsl");
  }
  return text;
}

}  // namespace boxprobe
