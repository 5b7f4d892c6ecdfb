// The light table from which techniques under test draw directions: the same for all inputs, on the CPU and the GPU.
#pragma once

#include "filters/math/cube/light_table.h"

namespace boxprobe::stress {

/// Of an invented capture of 4 x 4 texels per face: uneven, with a black face and a lamp ten thousand times as bright,
/// so that densities range from 0 to a lamp's.
const LightTable& stressLightTable();

}  // namespace boxprobe::stress
