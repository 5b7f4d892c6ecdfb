// `bench --whole`: techniques' whole pictures, diffuse light and all, against the path tracer's.
#pragma once

#include "app/cli/options/bench_options.h"

namespace boxprobe {

/// Of options.scenePath, or of every scene that comes with the program. Writes whole.json into the folder.
void runWholeBench(const BenchOptions& options);

}  // namespace boxprobe
