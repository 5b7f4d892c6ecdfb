// Puts probe lighting into the fragment shader VTK's polydata mapper has written for physically based shading. The only
// file that knows the text of VTK's surface shader: every anchor, the check that each one matched, the versions it was
// tried on.
#pragma once

#include <string>

#include "filters/vtk/draw_state.h"

namespace boxprobe {

/// Edits `fragmentSource` in place. Returns an empty string, or one line naming VTK's version and the anchor that is
/// not there (the source is then unchanged). A shader without physically based shading (no light, lines, points) has
/// nothing to splice and is left as it is.
/// With `debug` the program is one of the debug view: it can show any row of surfaceViews() and writes what the surface
/// is into further attachments.
std::string splicePbr(std::string& fragmentSource, const ProbeBinding& binding, bool debug = false);

/// Name of the uniform array that holds a number of `row` for each of a draw's probes.
std::string parameterUniform(const ParameterRow& row);

}  // namespace boxprobe
