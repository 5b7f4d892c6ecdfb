// VTK's warnings and errors as single lines of this program, in place of VTK's multi-line reports.
#pragma once

#include <string>

namespace boxprobe {

/// From now on VTK's warnings become `boxprobe: warning: VTK: ...` lines on stderr (none if `quiet`) and the first of
/// its errors is kept for firstVtkError(); `printErrors` prints each different error as well, for a program that goes
/// on.
void installVtkMessages(bool quiet, bool printErrors);

/// Empty, or the first error VTK reported since installVtkMessages, one line.
std::string firstVtkError();

}  // namespace boxprobe
