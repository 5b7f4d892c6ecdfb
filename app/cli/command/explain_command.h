// `boxprobe explain`: the whole calculation of one pixel, as text or JSON.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addExplainCommand(CLI::App& program);

}  // namespace boxprobe
