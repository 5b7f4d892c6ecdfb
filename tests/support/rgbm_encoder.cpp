#include "tests/support/rgbm_encoder.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <vector>

#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

float largest(const glm::vec3& v) {
  return std::max({v.x, v.y, v.z});
}

// What is not a number, or is negative, is 0: there is no such radiance.
glm::vec3 positive(const glm::vec3& v) {
  const auto of = [](float c) { return c > 0.0f ? c : 0.0f; };
  return {of(v.x), of(v.y), of(v.z)};
}

/// The byte whose colour is nearest to a value from 0 to 1.
std::uint8_t byteOf(float color, const RgbmInstruction& instruction) {
  if (!instruction.srgb) return static_cast<std::uint8_t>(std::lround(color * 255.0f));
  int low = 0, high = 255;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (linearOfSrgb(static_cast<std::uint8_t>(middle)) <= color ? low : high) = middle;
  }
  const float below = linearOfSrgb(static_cast<std::uint8_t>(low)),
              above = linearOfSrgb(static_cast<std::uint8_t>(high));
  return static_cast<std::uint8_t>(color - below <= above - color ? low : high);
}

RgbmTexel quantized(const glm::vec3& radiance, int multiplier, const RgbmInstruction& instruction) {
  const float scale = rgbmScale(static_cast<std::uint8_t>(multiplier), instruction);
  RgbmTexel texel{0, 0, 0, static_cast<std::uint8_t>(multiplier)};
  for (std::size_t c = 0; c < 3; ++c) {
    const float unit = scale > 0.0f ? radiance[static_cast<int>(c)] / scale : 0.0f;
    texel[c] = byteOf(std::clamp(unit, 0.0f, 1.0f), instruction);
  }
  return texel;
}

/// The smallest multiplier whose scale reaches `brightest`, from 1 to 255.
int smallestMultiplier(float brightest, const RgbmInstruction& instruction) {
  if (!(instruction.y > 0.0f)) return 255;  // M plays no part
  const float unit = std::pow(std::min(brightest / instruction.x, 1.0f), 1.0f / instruction.y);
  int multiplier = std::clamp(static_cast<int>(std::ceil(unit * 255.0f)), 1, 255);
  while (multiplier < 255 && rgbmScale(static_cast<std::uint8_t>(multiplier), instruction) < brightest)
    ++multiplier;  // rounding of the powers
  return multiplier;
}

glm::vec3 toHalf(const glm::vec3& v) {
  constexpr float kHalfMax = 65504.0f;
  const glm::vec3 inRange = glm::clamp(v, glm::vec3(-kHalfMax), glm::vec3(kHalfMax));
  const auto of = [](float c) { return glm::unpackHalf1x16(glm::packHalf1x16(c)); };
  return {of(inRange.x), of(inRange.y), of(inRange.z)};
}

double relativeError(const glm::vec3& value, const glm::vec3& reference) {
  const glm::vec3 difference = glm::abs(value - reference);
  return static_cast<double>(largest(difference)) / static_cast<double>(largest(reference));
}

}  // namespace

RgbmTexel encodeRgbm(const glm::vec3& radiance, const RgbmInstruction& instruction) {
  glm::vec3 color = positive(radiance);
  float brightest = largest(color);
  if (!(brightest > 0.0f) || !(instruction.x > 0.0f)) return {0, 0, 0, 0};
  if (brightest > instruction.x) {
    // Infinity has no hue to keep.
    color = std::isfinite(brightest) ? color * (instruction.x / brightest) : glm::vec3(instruction.x);
    brightest = instruction.x;
  }
  // A slightly larger multiplier may let all three components fall closer to their steps; beyond a few the steps
  // themselves are coarser by more than that.
  constexpr int kTried = 8;
  const int first = smallestMultiplier(brightest, instruction), last = std::min(first + kTried - 1, 255);
  RgbmTexel best{};
  float bestError = INFINITY;
  for (int multiplier = first; multiplier <= last; ++multiplier) {
    const RgbmTexel texel = quantized(color, multiplier, instruction);
    const float error = largest(glm::abs(decodeRgbm(texel, instruction) - color));
    if (error < bestError) {
      best = texel;
      bestError = error;
    }
  }
  return best;
}

RgbmError measureRgbm(const CubeMap& radiance, const RgbmInstruction& instruction) {
  RgbmError error;
  std::vector<double> relative;
  double squares = 0.0, sum = 0.0, sourceEnergy = 0.0, clippedEnergy = 0.0;
  for (int level = 0; level < radiance.levels(); ++level) {
    const int count = 6 * radiance.levelSize(level) * radiance.levelSize(level);
    const float* texels = radiance.face(level, 0);
    for (int i = 0; i < count; ++i) {
      const glm::vec3 exact(texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]);
      const glm::vec3 reference = toHalf(exact);
      ++error.texels;
      if (!(largest(glm::abs(reference)) > 0.0f)) continue;
      const glm::vec3 decoded = decodeRgbm(encodeRgbm(reference, instruction), instruction);
      const double energy = static_cast<double>(reference.x) + reference.y + reference.z;
      sourceEnergy += energy;
      if (largest(reference) > instruction.x || positive(reference) != reference) {
        ++error.clipped;
        clippedEnergy += energy - (static_cast<double>(decoded.x) + decoded.y + decoded.z);
        continue;
      }
      if (!(largest(decoded) > 0.0f)) ++error.vanished;
      relative.push_back(relativeError(decoded, reference));
      sum += relative.back();
      squares += relative.back() * relative.back();
      error.halfWorstRelative = std::max(error.halfWorstRelative, relativeError(reference, exact));
    }
  }
  if (sourceEnergy > 0.0) error.lostEnergy = clippedEnergy / sourceEnergy;
  if (relative.empty()) return error;
  const auto count = static_cast<double>(relative.size());
  error.meanRelative = sum / count;
  error.rmsRelative = std::sqrt(squares / count);
  const auto rank = static_cast<std::ptrdiff_t>(0.99 * (count - 1.0));
  std::nth_element(relative.begin(), relative.begin() + rank, relative.end());
  error.percentile99Relative = relative[static_cast<std::size_t>(rank)];
  error.worstRelative = *std::max_element(relative.begin(), relative.end());
  return error;
}

}  // namespace boxprobe
