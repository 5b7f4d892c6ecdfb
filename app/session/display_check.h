// Asks for an X display before VTK or Qt does: both abort the process where there is none. Called by `render` and the
// window, before either touches a window system.
#pragma once

#include <string>

namespace boxprobe {

/// Throws InputError if DISPLAY names no X server that can be reached, or one without GLX. `command` is what the user
/// ran, for the advice: "boxprobe render".
void requireDisplay(const std::string& command);

}  // namespace boxprobe
