// How far a technique is from the integral it stands for, over many points: in display values, in linear light, and how
// much light it gains or loses in each bucket of roughness and view angle.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "filters/reference/study/study_room.h"

namespace boxprobe::study {

/// x / (1 + x) to the 1/2.2.
double displayValue(double radiance);

using Technique = std::function<glm::dvec3(const RoomPoint&)>;
/// By its id.
Technique techniqueOf(const char* id);
/// At all points, on all cores.
std::vector<glm::dvec3> valuesOf(const Technique& technique, const std::vector<RoomPoint>& points);

constexpr std::size_t kBuckets = static_cast<std::size_t>(kRoughnesses) * kAngles;

struct TechniqueTally {
  double rmse = 0.0;          ///< of display values
  double relativeRmse = 0.0;  ///< root of: squared errors of linear light over squared light
  std::array<double, kRoughnesses> rmseByRoughness{};
  std::array<double, kBuckets> light{};  ///< over the reference's; bucket: kAngles * roughness + angle
  /// Of light, from the rooms' scatter about it: what other rooms made by the same chance would leave open.
  std::array<double, kBuckets> lightError{};
  double worstLight() const;    ///< largest |light - 1|
  std::size_t mostOff() const;  ///< the bucket whose light is farthest from 1
};

TechniqueTally tally(const std::vector<glm::dvec3>& values, const std::vector<RoomPoint>& points);

}  // namespace boxprobe::study
