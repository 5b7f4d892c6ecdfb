// `boxprobe place`: finds the rooms of a model and gives each a fitted probe, and more where they gain.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addPlaceCommand(CLI::App& program);

}  // namespace boxprobe
