// Asks for an X display before VTK or Qt does: both abort the process where there is none. Called by `render` and the
// window, before either touches a window system.
#pragma once

#include <string>

namespace boxprobe {

/// Does the environment name a display (DISPLAY)? True where windows are not X's.
bool displayIsNamed();

/// Throws InputError if DISPLAY names no X server that can be reached, or one without GLX; WorkError if that has no
/// visual or no OpenGL 3.2. Qt then uses X, too. `command` is what the user
/// ran, for the advice: "boxprobe render".
void requireDisplay(const std::string& command);

}  // namespace boxprobe
