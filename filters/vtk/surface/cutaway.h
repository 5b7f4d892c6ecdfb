// The cutaway view: a program variant that leaves out what stands between the eye and a box, and its uniforms. Only
// programs that asked for it test anything; the box moves by uniforms alone.
#pragma once

#include <string>

#include "filters/vtk/draw/window_view.h"

class vtkRenderer;
class vtkShaderProgram;

namespace boxprobe {

class AnchorEdits;

/// Adds the test to a spliced fragment shader.
void addCutaway(std::string& fragment, AnchorEdits& edits);
/// `cut` null: nothing is cut, as in captures.
void uploadCutaway(vtkShaderProgram* program, vtkRenderer* renderer, const CutBox* cut);

}  // namespace boxprobe
