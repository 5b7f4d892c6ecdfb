// Puts probe lighting into the fragment shader VTK's polydata mapper has written for physically based shading. Beside
// it stand the only files that know the text of VTK's surface shader: pbr_anchors.cpp has the lines of VTK 9.1 that are
// edited, vtk_text_forms.cpp brings newer versions' into these.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/surface/anchor_edits.h"
#include "filters/vtk/surface/fragment_source.h"

namespace boxprobe {

/// The shaders of one program as VTK has written them.
struct ShaderSources {
  std::string vertex;
  std::string geometry;  ///< empty unless VTK draws edges
  std::string fragment;
};

struct SpliceReport {
  bool needed = false;               ///< there is physically based shading, or there should be
  std::string failure;               ///< one line: VTK's version, the line sought, the file to mend; empty: none
  std::vector<AnchorCount> anchors;  ///< newer words first, then what was edited; up to the one that failed
};

/// Edits the sources in place; where an anchor is not there as often as it should be they stay unchanged, and the
/// report says so. `lit`: the object is to be shaded physically by lights, so that a program without any sign of it is
/// a failure, too; otherwise such a program (lines, points, no light) has nothing to splice and is left as it is.
SpliceReport splicePbr(ShaderSources& sources, const SurfaceProgram& program, bool lit);

}  // namespace boxprobe
