// The fixtures: one text for each version that writes another one.
#pragma once

#include <string>
#include <vector>

#include "tests/vtk/shader_text.h"

namespace boxprobe::test {

inline const std::vector<std::string>& textVersions() {
  static const std::vector<std::string> versions = {"9.1", "9.3", "9.5", "9.6.1", "9.6.2", "9.7", "master"};
  return versions;
}

inline ShaderSources fixture(const std::string& version, const std::string& program) {
  return readText(std::string(BOXPROBE_SOURCE_DIR) + "/tests/vtk/text/" + version + "-" + program + ".glsl");
}

/// From the first line of shading to the colour that is written, one statement a line, without comments.
std::string shadingOf(const std::string& fragment);

/// Programs that take every anchor between them, for a text with `lights` lights: what is drawn and how.
struct NamedProgram {
  std::string name;
  ProbeBinding binding;
  SurfaceMaterial surface;
  SurfaceOutput output = SurfaceOutput::Picture;
  LightForm form = LightForm::Single;

  std::vector<int> lightPlaces = {};
  SurfaceProgram program() const {
    SurfaceProgram made{binding, &surface, output, false, form};
    made.lightPlaces = lightPlaces;
    return made;
  }
};

std::vector<NamedProgram> programsFor(int lights);

}  // namespace boxprobe::test
