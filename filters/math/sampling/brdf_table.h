// The second half of the split sum: how much of F0 and of F90 a surface reflects, by N.V and roughness. Its numbers are
// made when the project is built (write_brdf_table.cpp), so that no start of the program waits for them.
// filters/vtk/draw/static_textures uploads it; vtk_pbr_splice.cpp reads it on the GPU, explanations on the CPU. The
// references do not: they judge it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace boxprobe {

/// Texels a side: cosine and roughness as splitSumPlace() in shaders/shared/split_sum.glsl has them. Between texels it
/// is off by at most 0.007, and by 0.0006 from N.V .01 and roughness .08 on (tests/unit/brdf_table_test.cpp).
constexpr int kBrdfTableSize = 128;

/// Pairs (F0's factor, F90's), 65535 for 1; rows of constant roughness, the smoothest first.
extern const std::uint16_t kBrdfTable[kBrdfTableSize * kBrdfTableSize * 2];

/// Factors of F0 and F90 as the GPU reads them: bilinear, clamped at the edges.
glm::vec2 splitSum(float nDotV, float roughness);

}  // namespace boxprobe
