// `boxprobe bake`: captures and filters the baked probes of a scene into a folder of OpenEXR files, which everything
// that draws the scene then uses. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

/// Adds the sub-command to `program`.
Subcommand addBakeCommand(CLI::App& program);

}  // namespace boxprobe
