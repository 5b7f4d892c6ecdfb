// Runs the commands of documents that are cheap: pictures, explanations, reports, sheets, small stress tests. What they
// write goes into a folder of the test. For tests/documents alone.
#pragma once

#include <string>

#include "tests/documents/command_line.h"

namespace boxprobe::test {

/// False for what opens a window, traces rays, measures for minutes, or is no example.
bool isCheap(const Command& command);

/// Runs it, `folder` in place of where it would write. Empty, or what went wrong.
std::string runCommand(const Command& command, const std::string& folder);

}  // namespace boxprobe::test
