// Does the driver take a program? Asked before VTK 9.1 uses one, which a refused program takes down. Costs no second
// compilation: VTK's cache then has it ready.
#pragma once

#include <string>

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// What is reported of a surface whose spliced program is refused.
constexpr const char* kSurfaceRefused =
    "this OpenGL driver refuses the shader of a surface with probes; it is drawn without reflections";

/// The context must be current.
bool programCompiles(vtkOpenGLRenderWindow* window, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment);

}  // namespace boxprobe
