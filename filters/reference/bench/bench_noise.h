// The kind of noise in an error, for techniques that draw rays at random: the part of its spectrum where the eye is
// most sensitive, and what remains after a small blur.
#pragma once

#include <vector>

#include "filters/reference/bench/bench_result.h"

namespace boxprobe {

/// `error`: one value per pixel, rows from the top, 0 wherever `mask` is false; those pixels do not count.
NoiseFigures noiseFigures(const std::vector<float>& error, const std::vector<bool>& mask, int width, int height);

}  // namespace boxprobe
