// The search for the box of least error: tries every combination of given planes, and refines one box.
#pragma once

#include <functional>

#include "filters/fit/box/face_planes.h"
#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

/// Called with the finished fraction, 0 to 1; returning false stops the work.
using FitProgress = std::function<bool(double)>;

struct RatedBox {
  OffsetBox box;
  double meanDegrees = 0.0;
};

/// The best `count` of all combinations, best first. `rays` are along axes rotated by `yaw`, which is stored in each
/// result. Throws std::logic_error for a face without an offset.
std::vector<RatedBox> bestCombinations(const LookupRays& rays, const std::array<std::vector<double>, kFaces>& offsets,
                                       std::size_t count, double yaw);

struct PolishSettings {
  std::array<bool, kFaces> faces{true, true, true, true, true, true};  ///< which faces may move
  bool yaw = true;
  double firstStep = 0.05, lastStep = 0.0003;  ///< relative to the box's extent; of yaw in radians
  double nearest = 0.0;                        ///< minimum distance of a face from the origin
};

/// Pattern search: steps along faces, pairs of faces (moved and spread together) and yaw, about the origin and about
/// the middle of the box. A successful step grows, any other is halved. Derivatives are no use, because the mean error
/// has a kink wherever a ray's error is 0.
RatedBox polished(const LookupRays& rays, const OffsetBox& start, const PolishSettings& settings);

/// The longest side.
double extentOf(const OffsetBox& box);

/// Moves some faces slightly outwards from what they are fitted to. Reflecting points close behind a face then lie
/// inside, if that costs little; behind a doorway they stay outside.
OffsetBox withMargin(OffsetBox box, const LookupRays& rays, const std::array<bool, kFaces>& faces);

}  // namespace boxprobe
