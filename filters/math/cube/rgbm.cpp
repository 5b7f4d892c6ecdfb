#include "filters/math/cube/rgbm.h"

#include <cmath>

#include "filters/math/cube/srgb.h"

namespace boxprobe {

float rgbmScale(std::uint8_t m, const RgbmInstruction& instruction) {
  return instruction.x * std::pow(static_cast<float>(m) / 255.0f, instruction.y);
}

glm::vec3 decodeRgbm(const RgbmTexel& texel, const RgbmInstruction& instruction) {
  const float scale = rgbmScale(texel[3], instruction);
  if (!instruction.srgb) return scale / 255.0f * glm::vec3(texel[0], texel[1], texel[2]);
  return scale * glm::vec3(linearOfSrgb(texel[0]), linearOfSrgb(texel[1]), linearOfSrgb(texel[2]));
}

}  // namespace boxprobe
