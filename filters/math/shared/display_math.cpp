// The translation unit that compiles shaders/shared/display.glsl and tone.glsl as C++.
#include "filters/math/shared/display_math.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

using glm::mat3;
using glm::vec3;

#include "shaders/shared/display.glsl"
#include "shaders/shared/tone.glsl"

}  // namespace boxprobe::shading

namespace boxprobe {

glm::vec3 toneMapped(const glm::vec3& light, Tone tone) {
  switch (tone) {
    case Tone::Neutral:
      return shading::toneNeutral(light);
    case Tone::Agx:
      return shading::toneAgx(light);
    case Tone::Aces:
      return shading::toneAces(light);
    case Tone::None:
    case Tone::AsVtk:
      break;
  }
  return glm::clamp(light, glm::vec3(0.0f), glm::vec3(1.0f));
}

glm::vec3 lightShownAs(const glm::vec3& shown, Tone tone) {
  if (tone == Tone::None || tone == Tone::AsVtk) return shown;
  constexpr float kLeast = 1.0e-4f, kMost = 64.0f;
  constexpr int kSteps = 200;
  glm::vec3 light = glm::max(shown, glm::vec3(kLeast));
  for (int step = 0; step < kSteps; ++step) {
    const glm::vec3 now = toneMapped(light, tone);
    for (int c = 0; c < 3; ++c) {
      const float factor = (shown[c] + kLeast) / (now[c] + kLeast);
      light[c] = std::clamp(light[c] * std::sqrt(factor), kLeast * kLeast, kMost);
    }
  }
  return light;
}

const char* toneFunction(Tone tone) {
  switch (tone) {
    case Tone::Neutral:
      return "toneNeutral";
    case Tone::Agx:
      return "toneAgx";
    case Tone::Aces:
      return "toneAces";
    case Tone::None:
    case Tone::AsVtk:
      break;
  }
  return "";
}

std::uint8_t displayByte(double light) {
  if (!(light > 0.0)) return 0;
  return static_cast<std::uint8_t>(
      std::lround(255.0f * shading::srgbEncoded(static_cast<float>(std::min(light, 1.0)))));
}

std::array<std::uint8_t, 3> displayBytes(const glm::vec3& linear, double exposure, Tone tone) {
  const glm::vec3 shown = toneMapped(static_cast<float>(exposure) * linear, tone);
  return {displayByte(shown.x), displayByte(shown.y), displayByte(shown.z)};
}

}  // namespace boxprobe
