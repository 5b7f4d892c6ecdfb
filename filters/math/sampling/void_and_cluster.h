// Blue-noise masks by the void-and-cluster method (Ulichney 1993): the pixels of a square that repeats, ranked such
// that those below any rank are spread evenly. Called by blue_noise; knows no picture.
#pragma once

#include <cstdint>
#include <vector>

namespace boxprobe {

/// A permutation of 0 .. size² - 1, row by row. The same for the same seed. Time: size to the fourth power; 64:
/// milliseconds.
std::vector<std::uint16_t> voidAndCluster(int size, std::uint32_t seed);

}  // namespace boxprobe
