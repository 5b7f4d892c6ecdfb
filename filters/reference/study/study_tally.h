// The error of a technique against its integral over many points: in display values, in linear light, and as gain or
// loss of light by roughness and view angle.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "filters/reference/study/study_room.h"

namespace boxprobe::study {

/// (x / (1 + x))^(1/2.2).
double displayValue(double radiance);

using Technique = std::function<glm::dvec3(const RoomPoint&)>;
/// Finds a technique by its id.
Technique techniqueOf(const char* id);
/// Evaluates all points, on all cores.
std::vector<glm::dvec3> valuesOf(const Technique& technique, const std::vector<RoomPoint>& points);

constexpr std::size_t kBuckets = static_cast<std::size_t>(kRoughnesses) * kAngles;

struct TechniqueTally {
  double rmse = 0.0;          ///< of display values
  double relativeRmse = 0.0;  ///< root of squared errors of linear light over squared light
  std::array<double, kRoughnesses> rmseByRoughness{};
  std::array<double, kBuckets> light{};  ///< relative to the reference; bucket: kAngles * roughness + angle
  /// Standard error of `light`, from its scatter among rooms.
  std::array<double, kBuckets> lightError{};
  double worstLight() const;    ///< largest |light - 1|
  std::size_t mostOff() const;  ///< the bucket of worstLight()
};

TechniqueTally tally(const std::vector<glm::dvec3>& values, const std::vector<RoomPoint>& points);

}  // namespace boxprobe::study
