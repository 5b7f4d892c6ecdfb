// The text of VTK's surface shader as files: read, written, and taken from the VTK that runs.
#pragma once

#include <map>
#include <string>

#include "filters/vtk/surface/vtk_pbr_splice.h"

class vtkRenderWindow;

namespace boxprobe::test {

/// A program a file: its three sources, each after a line that names it.
ShaderSources readText(const std::string& file);
void writeText(const std::string& file, const ShaderSources& text);

/// What the VTK that runs writes before any splice, by the names of the files without version: `lamps` (a spot light
/// beside a directional one, a clear coat, edges), `surroundings` (its own image-based lighting, colours at the
/// vertices), `lines` (no lighting).
std::map<std::string, ShaderSources> runningText(vtkRenderWindow* window);

}  // namespace boxprobe::test
