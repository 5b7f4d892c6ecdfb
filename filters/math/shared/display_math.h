// shaders/shared/display.glsl and tone.glsl as C++: what pictures, previews and explanations show of linear light, by
// the same source as the window. The definitions are in display_math.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace boxprobe::shading {

float srgbEncoded(float light);
glm::vec3 srgbEncoded(glm::vec3 light);
float srgbDecoded(float shown);
glm::vec3 srgbDecoded(glm::vec3 shown);
glm::vec3 toneNeutral(glm::vec3 light);
glm::vec3 toneAgx(glm::vec3 light);
glm::vec3 toneAces(glm::vec3 light);

}  // namespace boxprobe::shading

namespace boxprobe {

/// How light that is brighter than a display's white is shown. After exposure, before the display's transfer curve.
enum class Tone {
  None,     ///< what is brighter than white is white
  Neutral,  ///< Khronos PBR Neutral: colours as they are, highlights compressed
  Agx,      ///< AgX: brightness compressed from far below to far above, bright colours become white
  Aces,     ///< the Academy's film-like contrast, by Hill's fit
  AsVtk,    ///< none, and VTK's power of 1 / 2.2 for the curve: where VTK's own pictures stand beside
};

/// Light on a display, 0 to 1, of the light of a scene times the exposure. AsVtk is as None.
glm::vec3 toneMapped(const glm::vec3& light, Tone tone);

/// The light that a tone shows as a colour, each channel from 0 to 1: found step by step, off by less than a step of 8
/// bits where the tone has that colour, else the nearest that the steps come to.
glm::vec3 lightShownAs(const glm::vec3& shown, Tone tone);

/// Its name in shaders/shared/tone.glsl; empty for none.
const char* toneFunction(Tone tone);

/// Byte that a display is sent for light from 0 to 1, by the curve of sRGB; clamped, 0 for what is no number. Off by
/// less than 0.001 of a step before it is rounded.
std::uint8_t displayByte(double light);

/// Bytes of red, green and blue of a scene's linear light, as the program's pictures have them.
std::array<std::uint8_t, 3> displayBytes(const glm::vec3& linear, double exposure, Tone tone = Tone::None);

}  // namespace boxprobe
