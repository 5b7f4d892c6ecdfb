// The light table that techniques under test draw directions from: one for all inputs, the same on the CPU and on the
// GPU. Called by stress_map and the program of the GPU.
#pragma once

#include "filters/math/cube/light_table.h"

namespace boxprobe::stress {

/// Of a made-up capture of 4 x 4 texels per face: uneven, with a face that is black and one lamp ten thousand times as
/// bright, so that densities reach from 0 to what lamps have.
const LightTable& stressLightTable();

}  // namespace boxprobe::stress
