// The colours of boxes and handles: X red, Y green, Z blue as usual, and distinct colours for box, blend and origin
// that are visible on light and dark pictures.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Display colours, 0 to 1.
struct HandleColors {
  std::array<glm::dvec3, 3> axes = {display(0xf05550), display(0x7ac943), display(0x4f9dff)};
  glm::dvec3 box = display(0xffb31a);        ///< edges of the selected probe's box
  glm::dvec3 blend = display(0x4de0e0);      ///< box of full weight
  glm::dvec3 influence = display(0xc08cff);  ///< a separate influence box
  glm::dvec3 origin = display(0xff5fd2);     ///< capture origin
  glm::dvec3 idle = display(0xe8e8e8);       ///< probes that are not selected
  glm::dvec3 ghost = display(0x6de87a);      ///< a proposed box
  glm::dvec3 halo = display(0x101216);       ///< outline of all of them

  static glm::dvec3 display(int rgb) { return glm::dvec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0; }
};

}  // namespace boxprobe
