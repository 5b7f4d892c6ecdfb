// `boxprobe report`: scenes reviewed in one HTML file. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addReportCommand(CLI::App& program);

}  // namespace boxprobe
