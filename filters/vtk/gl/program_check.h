// Tests whether the driver accepts a program before VTK 9.1, which crashes on a refused one, uses it. There is no
// second compilation: VTK's cache then contains it.
#pragma once

#include <string>

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// The message for a surface whose spliced program is refused.
constexpr const char* kSurfaceRefused =
    "this OpenGL driver refuses the shader of a surface with probes, which has no reflections without it; use fewer "
    "probes or textures on one object";
/// The same for a debug view, and for the program that reads back a pixel's inputs. The picture is still drawn.
constexpr const char* kViewRefused =
    "this OpenGL driver refuses the shader of this debug view on a surface; choose the picture, or fewer probes or "
    "textures on one object";
constexpr const char* kExplainRefused =
    "this OpenGL driver refuses the shader that explains this surface; use fewer probes or textures on one object";

/// Textures that a fragment program may sample here. The environment variable BOXPROBE_TEXTURE_UNITS lowers it, to see
/// what a card with fewer shows. The context must be current.
int textureUnits();

/// Also false if it samples more than textureUnits(). The context must be current. `quiet`: VTK does not report a
/// refusal, as another program is tried then.
bool programCompiles(vtkOpenGLRenderWindow* window, const std::string& vertex, const std::string& geometry,
                     const std::string& fragment, bool quiet);

}  // namespace boxprobe
