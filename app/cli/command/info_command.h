// `boxprobe info`: what is in a scene and what of it would be skipped. Needs no display. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addInfoCommand(CLI::App& program);

}  // namespace boxprobe
