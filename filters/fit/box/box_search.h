// The search for the box of least error: every combination of given planes, and the polish of one box. Called by
// fit_box and by the table that compares it with brute force.
#pragma once

#include <functional>

#include "filters/fit/box/face_planes.h"
#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

/// Told how far the work is, 0 to 1; false stops it.
using FitProgress = std::function<bool(double)>;

struct RatedBox {
  OffsetBox box;
  double meanDegrees = 0.0;
};

/// The best `count` of all combinations, best first; `yaw` is written into each: `rays` lie along axes turned by it.
/// A face without an offset throws std::logic_error.
std::vector<RatedBox> bestCombinations(const LookupRays& rays, const std::array<std::vector<double>, kFaces>& offsets,
                                       std::size_t count, double yaw);

struct PolishSettings {
  std::array<bool, kFaces> faces{true, true, true, true, true, true};  ///< which may move
  bool yaw = true;
  double firstStep = 0.05, lastStep = 0.0003;  ///< relative to the box's extent; of yaw in radians
  double nearest = 0.0;                        ///< a face comes no closer to the origin
};

/// Pattern search: steps along faces, pairs of faces (moved and spread together) and yaw, about the origin and about
/// the middle of the box; a step that helps grows, another halves. The mean error has a kink wherever a ray's error is
/// 0, which derivatives do not survive.
RatedBox polished(const LookupRays& rays, const OffsetBox& start, const PolishSettings& settings);

/// The longest side.
double extentOf(const OffsetBox& box);

/// Some faces a little outside of what they are fitted to. Points that reflect and lie close behind a face come inside
/// where that costs little: behind a doorway they do not.
OffsetBox withMargin(OffsetBox box, const LookupRays& rays, const std::array<bool, kFaces>& faces);

}  // namespace boxprobe
