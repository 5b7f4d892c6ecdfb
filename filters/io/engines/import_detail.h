// What the readers of engines' texts share. Internal to this folder.
#pragma once

#include <charconv>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "filters/io/engines/probe_import.h"

namespace boxprobe {

/// Where something stands: of a node, and of its children in it.
struct Placement {
  glm::dmat3 axes{1.0};  ///< columns, with their scale
  glm::dvec3 position{0.0};
  Placement within(const Placement& parent) const {
    return {parent.axes * axes, parent.axes * position + parent.position};
  }
};

/// The number at the beginning of a text, spaces skipped; nothing for what is none, or infinite.
inline std::optional<double> leadingNumber(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t");
  if (at == std::string_view::npos) return {};
  double value = 0.0;
  const auto result = std::from_chars(text.data() + at, text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value)) return {};
  return value;
}

/// Degrees about X, then Y, then Z, as rotationMatrix() takes them, of a rotation.
inline glm::dvec3 rotationDegreesOf(const glm::dmat3& m) {
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  const double sine = std::fmin(std::fmax(-m[0][2], -1.0), 1.0);
  // Looking along the axis: x and z turn about the same line, and x takes all of it.
  if (std::abs(sine) > 1.0 - 1e-12)
    return {kDegrees * std::atan2(sine * m[1][0], m[1][1]), kDegrees * std::asin(sine), 0.0};
  return {kDegrees * std::atan2(m[1][2], m[2][2]), kDegrees * std::asin(sine), kDegrees * std::atan2(m[0][1], m[0][0])};
}

/// A name that none has yet: a probe's names are unique here and not there.
inline std::string uniqueName(std::set<std::string>& taken, const std::string& wanted) {
  const std::string stem = wanted.empty() ? "probe" : wanted;
  std::string name = stem;
  for (int number = 2; !taken.insert(name).second; ++number) name = stem + " " + std::to_string(number);
  return name;
}

}  // namespace boxprobe
