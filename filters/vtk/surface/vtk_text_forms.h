// What VTK versions after 9.1 write into their surface shader, brought into 9.1's words, so that the splice
// (vtk_pbr_splice.h) has one text to stand on. Goes by the text it finds, never by a version number. The texts of each
// version are kept in tests/vtk.
#pragma once

#include <string>

#include "filters/vtk/surface/anchor_edits.h"

namespace boxprobe {

/// Lights that the fragment shader declares, and whether their text tells positional ones from directional ones.
struct DeclaredLights {
  int count = 0;
  bool positional = false;
};

DeclaredLights declaredLights(const std::string& fragment);

/// Edits `fragment` in place; what is in 9.1's words already, or not there at all, stays. Each form and how often it
/// was found is in `edits` afterwards.
void normalizeForms(std::string& fragment, AnchorEdits& edits);

}  // namespace boxprobe
