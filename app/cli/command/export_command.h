// `boxprobe export`: probes as files that engines load, with what they need to know beside them, or a technique as a
// function for their shaders. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

/// Adds the sub-command to `program`.
Subcommand addExportCommand(CLI::App& program);

}  // namespace boxprobe
