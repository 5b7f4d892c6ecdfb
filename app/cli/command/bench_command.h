// `boxprobe bench`: run time against error of every technique, as numbers, tables and pictures. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addBenchCommand(CLI::App& program);

}  // namespace boxprobe
