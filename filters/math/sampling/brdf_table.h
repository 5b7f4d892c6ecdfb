// The second half of the split sum: the factors of F0 and F90 by N.V and roughness. The table is made when the project
// is built (write_brdf_table.cpp), so that the program's start does not wait for it. The references do not use it,
// because they judge it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace boxprobe {

/// Texels per side; cosine and roughness are mapped as in splitSumPlace() of shaders/shared/split_sum.glsl. Between
/// texels the error is at most 0.007, and 0.0006 for N.V >= 0.01 and roughness >= 0.08
/// (tests/unit/brdf_table_test.cpp).
constexpr int kBrdfTableSize = 128;

/// Pairs (factor of F0, factor of F90) with 65535 for 1; rows of constant roughness, the smoothest first.
extern const std::uint16_t kBrdfTable[kBrdfTableSize * kBrdfTableSize * 2];

/// Factors of F0 and F90 as the GPU reads them: bilinear, clamped at the edges.
glm::vec2 splitSum(float nDotV, float roughness);

}  // namespace boxprobe
