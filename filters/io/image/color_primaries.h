// Linear light of other primaries as linear Rec. 709: the colours that pictures of the surroundings say they are in.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>

namespace boxprobe {

/// CIE 1931 chromaticities (x, y).
struct ColorPrimaries {
  glm::dvec2 red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};
};

/// Those of the Academy's interchange files (SMPTE ST 2065-1).
ColorPrimaries acesPrimaries();

/// Converts `from` to Rec. 709: white becomes white, adapted as by Bradford. The unit matrix, exactly, if `from` is
/// Rec. 709 but for rounding. Nothing if the primaries span no colours or a number is not finite.
std::optional<glm::dmat3> rec709From(const ColorPrimaries& from);

/// Converts CIE XYZ, not adapted: Rec. 709's white is D65, XYZ (0.9505, 1, 1.0891).
glm::dmat3 rec709FromXyz();

}  // namespace boxprobe
