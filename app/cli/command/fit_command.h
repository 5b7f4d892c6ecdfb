// `boxprobe fit`: boxes and origins of probes from what they see. Called by main; needs no display.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addFitCommand(CLI::App& program);

}  // namespace boxprobe
