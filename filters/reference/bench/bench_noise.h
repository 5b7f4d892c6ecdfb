// What kind of noise an error is: how much of its spectrum lies where the eye sees it best, and how much a small blur
// leaves. Called by the benchmark for techniques that draw rays at random.
#pragma once

#include <vector>

#include "filters/reference/bench/bench_result.h"

namespace boxprobe {

/// `error`: a value a pixel of a picture, rows from the top, 0 wherever `mask` is false, where it does not count.
NoiseFigures noiseFigures(const std::vector<float>& error, const std::vector<bool>& mask, int width, int height);

}  // namespace boxprobe
