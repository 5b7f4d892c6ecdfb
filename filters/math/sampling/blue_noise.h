// The mask that shifts a pixel's samples where they follow the pattern `blue`: 64 x 64 pixels, repeated over the
// picture, one void-and-cluster mask for each of a sample's two coordinates. Made when first asked for, which takes a
// few milliseconds: less than to read it from a file would be worth. It is still; over frames the samples themselves go
// on (shaders/shared/sample_pattern.glsl). Called by the mathematics on the CPU and by the graphics side's texture.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace boxprobe {

constexpr int kBlueNoiseSize = 64;

/// Row by row, each coordinate in (0, 1): a rank's middle.
const std::vector<glm::vec2>& blueNoise();
/// Of any pixel of a picture.
glm::vec2 blueNoiseAt(const glm::ivec2& pixel);

}  // namespace boxprobe
