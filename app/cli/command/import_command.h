// `boxprobe import`: the probes of a Unity or Godot scene as a scene file. Called by main.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

/// Adds the sub-command to `program`.
Subcommand addImportCommand(CLI::App& program);

}  // namespace boxprobe
