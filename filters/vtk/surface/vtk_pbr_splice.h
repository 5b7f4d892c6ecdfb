// Inserts probe lighting into the fragment shader that VTK's polydata mapper has written for physically based shading.
// Besides this file, two others depend on VTK's shader text: pbr_anchors.cpp has the edited lines of VTK 9.1,
// vtk_text_forms.cpp converts newer versions' text to them.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/surface/anchor_edits.h"
#include "filters/vtk/surface/fragment_source.h"

namespace boxprobe {

/// The shaders of one program as written by VTK.
struct ShaderSources {
  std::string vertex;
  std::string geometry;  ///< empty unless VTK draws edges
  std::string fragment;
};

struct SpliceReport {
  bool needed = false;               ///< there is physically based shading, or there should be
  std::string failure;               ///< one line: VTK's version, the line sought, the file to fix; empty: none
  std::vector<AnchorCount> anchors;  ///< conversions of newer text first, then edits; up to the one that failed
};

/// One line about edits that failed; empty: none has.
std::string spliceFailure(const AnchorEdits& edits);

/// Edits the sources in place. If an anchor does not have the expected number of matches they are unchanged, and the
/// report says so. `lit`: the object should have physically based shading with lights, so a program without it is a
/// failure, too; otherwise such a program (lines, points, no light) needs no splice.
SpliceReport splicePbr(ShaderSources& sources, const SurfaceProgram& program, bool lit);

}  // namespace boxprobe
