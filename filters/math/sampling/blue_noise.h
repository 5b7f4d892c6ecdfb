// The mask that shifts a pixel's samples for the pattern `blue`: 64 x 64 pixels, repeated over the picture, one
// void-and-cluster mask for each of a sample's two coordinates. Made at the first use, in a few milliseconds: too few
// to be worth a file. The mask stays the same in every frame; the samples advance (shaders/shared/sample_pattern.glsl).
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace boxprobe {

constexpr int kBlueNoiseSize = 64;

/// Row by row; each coordinate in (0, 1) is the middle of its rank.
const std::vector<glm::vec2>& blueNoise();
/// The value at any pixel of a picture.
glm::vec2 blueNoiseAt(const glm::ivec2& pixel);

}  // namespace boxprobe
