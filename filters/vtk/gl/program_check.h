// Does the driver take a program? Asked before VTK 9.1 uses one, which a refused program takes down. Costs no second
// compilation: VTK's cache then has it ready.
#pragma once

#include <string>

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// What is reported of a surface whose spliced program is refused.
constexpr const char* kSurfaceRefused =
    "this OpenGL driver refuses the shader of a surface with probes, which has no reflections without it; use fewer "
    "probes or textures on one object";
/// The same of a debug view, and of the program that reads back what a pixel is made from. The picture goes on.
constexpr const char* kViewRefused =
    "this OpenGL driver refuses the shader of this debug view on a surface; choose the picture, or fewer probes or "
    "textures on one object";
constexpr const char* kExplainRefused =
    "this OpenGL driver refuses the shader that explains this surface; use fewer probes or textures on one object";

/// The context must be current.
bool programCompiles(vtkOpenGLRenderWindow* window, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment);

}  // namespace boxprobe
