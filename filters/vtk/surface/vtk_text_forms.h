// Converts the surface shaders of VTK versions after 9.1 to 9.1's text, so that the splice (vtk_pbr_splice.h) handles a
// single form. Depends on the text, never on a version number. The texts of each version are in tests/vtk.
#pragma once

#include <string>

#include "filters/vtk/surface/anchor_edits.h"

namespace boxprobe {

/// The lights declared in the fragment shader, and whether the text distinguishes positional from directional ones.
struct DeclaredLights {
  int count = 0;
  bool positional = false;
};

DeclaredLights declaredLights(const std::string& fragment);

/// Edits `fragment` in place; text in 9.1's form, or missing text, is unchanged. `edits` then contains each form and
/// its number of matches.
void normalizeForms(std::string& fragment, AnchorEdits& edits);

}  // namespace boxprobe
