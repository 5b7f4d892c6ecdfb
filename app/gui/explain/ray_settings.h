// What rays are drawn: where they start, which of their lines, in which colours. Plain values; set by the ray panel,
// obeyed by the ray rig.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "filters/vtk/rays/ray_arrays.h"
#include "filters/vtk/rays/ray_colors.h"

namespace boxprobe {

enum class RaySource {
  Pointer,  ///< what is explained: under the pointer, or pinned
  Clicked,  ///< every point clicked with the tool
  Object,   ///< spread over one object
  Line,     ///< between the last two points clicked
  Screen,   ///< a grid of pixels
};

struct RaySettings {
  bool shown = true;
  RaySource source = RaySource::Pointer;
  std::string object;            ///< of RaySource::Object; empty: the one clicked last
  int count = 24;                ///< points at most
  double maximumLength = 100.0;  ///< of rays that hit nothing, scene units
  /// By RayKind: eye ray, normal, reflected ray, lookup, sample, true hit, error.
  std::array<bool, kRayKinds> kinds{true, true, true, true, true, true, true, true, true, true};
  RayColoring coloring = RayColoring::Kind;
  std::optional<RayRange> locked;
};

}  // namespace boxprobe
