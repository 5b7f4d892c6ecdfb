#include "tests/vtk/texts.h"

#include <regex>

namespace boxprobe::test {

std::string shadingOf(const std::string& fragment) {
  const std::size_t from = fragment.find("vec3 albedo = "), to = fragment.find("//VTK::Light::Impl", from);
  if (from == std::string::npos || to == std::string::npos) return {};
  const std::string text = std::regex_replace(fragment.substr(from, to - from), std::regex(" *//[^\n]*"), "");
  return std::regex_replace(text, std::regex("\\s*\n\\s*"), "\n");
}

std::vector<NamedProgram> programsFor(int lights) {
  NamedProgram plain;
  plain.name = "plain";

  NamedProgram sky = plain;
  sky.name = "sky";
  sky.binding.lighting = Lighting::Probes;

  NamedProgram probe = sky;
  probe.name = "a probe and its shadows";
  probe.binding.probes.push_back(std::make_shared<DrawnProbe>());
  for (int i = 0; i < lights; ++i) probe.binding.shadowLights.push_back(i);
  probe.binding.movingLights = {lights - 1};
  probe.surface.colors = true;

  NamedProgram debug = probe;
  debug.name = "debug view";
  debug.output = SurfaceOutput::Debug;

  NamedProgram multiple = probe;
  multiple.name = "multiple scattering";
  multiple.form = LightForm::Multiple;
  multiple.output = SurfaceOutput::SpecularSeparate;

  NamedProgram stock = sky;
  stock.name = "VTK's lamps";
  stock.form = LightForm::Vtk;

  NamedProgram glass = sky;
  glass.name = "glass";
  glass.surface.glass.drawn = true;
  glass.surface.glass.form = GlassForm::OnePass;
  return {plain, sky, probe, debug, multiple, stock, glass};
}

}  // namespace boxprobe::test
