// `boxprobe stress`: the projection mathematics under adversarial inputs. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addStressCommand(CLI::App& program);

}  // namespace boxprobe
