// The second half of the split sum: how much of F0 and of F90 a surface reflects, by N.V and roughness. Computed on the
// CPU once, in milliseconds: VTK's own table (1024² texels, 1024 samples each) takes seconds on a software renderer.
// filters/vtk/draw/static_textures uploads it; vtk_pbr_splice.cpp reads it on the GPU, explain, reference on the CPU.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace boxprobe {

struct BrdfTable {
  int columns = 0;                ///< N.V, texel centres (i + 0.5) / columns
  int rows = 0;                   ///< perceptual roughness, texel centres
  std::vector<glm::vec2> texels;  ///< x scales F0, y scales F90
};

/// Single-scatter GGX as VTK 9.1 shades its image-based light: Schlick's masking with k = alpha / 2 (Karis 2013).
glm::vec2 integrateBrdf(float cosine, float roughness, int samples);
BrdfTable makeBrdfTable(int columns = 128, int rows = 64, int samples = 64);

/// Factors of F0 and F90 as the GPU reads them: half precision, bilinear, clamped at the edges.
glm::vec2 sampleBrdf(const BrdfTable& table, float nDotV, float roughness);

}  // namespace boxprobe
