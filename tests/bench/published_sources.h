// The program's shaders with the robust forms taken out again: what a frame costs without them. For bench_robust alone,
// which replaces shaderSource() by its own.
#pragma once

namespace boxprobe::bench {

/// From now on shaderSource() gives the published forms, or the program's own. What is compiled already stays as it is.
void usePublishedShaders(bool published);

}  // namespace boxprobe::bench
