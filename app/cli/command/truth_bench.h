// `boxprobe bench --truth`: references and techniques against the pictures of an independent path tracer. Called by
// bench_command.
#pragma once

#include "app/cli/options/bench_options.h"

namespace boxprobe {

/// Writes truth.json into the folder and prints one table. Throws InputError where there is no truth file, or nothing
/// to compare.
void runTruthBench(const BenchOptions& options);

}  // namespace boxprobe
