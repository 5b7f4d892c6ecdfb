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
  probe.binding.sunLights = {SunUse{0, 0}};
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

  NamedProgram finish = multiple;
  finish.name = "every finish";
  finish.surface.tangents = true;
  finish.surface.finish.specularEdge = 0.5f;
  finish.surface.finish.sheenColor = glm::vec3(1.0f);
  finish.surface.finish.anisotropy = 0.5f;
  finish.surface.finish.iridescence = 1.0f;

  NamedProgram finishDebug = finish;
  finishDebug.name = "every finish, debug view";
  finishDebug.form = LightForm::Single;
  finishDebug.output = SurfaceOutput::Debug;

  NamedProgram finishStock = finish;
  finishStock.name = "every finish, VTK's lamps";
  finishStock.form = LightForm::Vtk;
  finishStock.output = SurfaceOutput::Picture;
  std::vector<NamedProgram> programs = {plain, sky,   probe,  debug,       multiple,
                                        stock, glass, finish, finishDebug, finishStock};
  // VTK's last light lends its code to a list of others.
  for (std::size_t i = 0; lights > 1 && i < 10; i += 3) {
    NamedProgram listed = programs[i];
    listed.name += ", lights from a list";
    listed.lightPlaces = {0, -1, -1};
    programs.push_back(listed);
  }
  return programs;
}

}  // namespace boxprobe::test
