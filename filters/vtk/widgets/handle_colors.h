// The colours of boxes and handles: X red, Y green, Z blue as usual, and distinct colours for box, blend and origin
// that are visible on light and dark pictures. Those of one shape differ in lightness as well, for eyes without one
// kind of cones: the three axes, and the lines and marks of box, influence, origin and other probes. Dashes tell the
// box of full weight and proposals from the rest.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Display colours, 0 to 1.
struct HandleColors {
  std::array<glm::dvec3, 3> axes = {display(0xe25650), display(0xb2f262), display(0x4f9dff)};
  glm::dvec3 box = display(0xffb31a);        ///< edges of the selected probe's box
  glm::dvec3 blend = display(0x4de0e0);      ///< box of full weight
  glm::dvec3 influence = display(0xbf92ff);  ///< a separate influence box
  glm::dvec3 origin = display(0xff15a0);     ///< capture origin
  glm::dvec3 idle = display(0xeeeeef);       ///< probes that are not selected
  glm::dvec3 ghost = display(0x6de87a);      ///< a proposed box
  glm::dvec3 halo = display(0x101216);       ///< outline of all of them

  static glm::dvec3 display(int rgb) { return glm::dvec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0; }
};

}  // namespace boxprobe
