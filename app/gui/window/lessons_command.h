// `boxprobe lessons`: lists the lessons, opens one in the window, draws them on sheets or a page, holds them to their
// claims. Here and not in app/cli because sheets are set with Qt's text.
#pragma once

#include "app/cli/options/subcommand.h"

namespace boxprobe {

/// `argc` and `argv`, which Qt wants, must outlive what is returned.
Subcommand addLessonsCommand(CLI::App& program, int& argc, char** argv);

}  // namespace boxprobe
