// `boxprobe render`: a scene drawn without a window, into a PNG or EXR file. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

Subcommand addRenderCommand(CLI::App& program);

}  // namespace boxprobe
