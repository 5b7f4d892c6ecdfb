// Rows of an explanation, formatted from values: scalars, vectors, light.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/fixed_text.h"

namespace boxprobe {

struct ExplanationRow {
  std::string symbol;                ///< "P", "t_x": what follows an underscore is a subscript
  std::vector<std::string> numbers;  ///< none, one or three
  std::string unit;                  ///< "" for a pure number
  std::string meaning;               ///< description, or the formula with its numbers
  std::optional<glm::vec3> color;    ///< linear light, shown as a swatch
  bool marked = false;               ///< decisive: the smallest slab factor
  bool sum = false;                  ///< the sum of the rows above
  bool detail = false;               ///< belongs to the row above: a texel of a lookup
};

struct ExplanationSection {
  std::string title;
  std::vector<ExplanationRow> rows;
  int probe = -1;  ///< index in Explanation::probes of the section's probe
};

/// "-x" .. "+z" for a ProbeExplanation's face.
std::string boxFaceName(int face);
/// "+X" .. "-Z" for a face of a cubemap in OpenGL's order.
std::string cubeFaceName(int face);

namespace explained {

inline constexpr const char* kLength = "scene units";

/// Components that are rounding errors relative to the largest are shown as 0.
template <typename Vector>
std::vector<std::string> numbers(const Vector& v) {
  constexpr double kRounding = 1e-6;
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  const auto text = [largest](double x) { return fixedText(std::abs(x) < kRounding * largest ? 0.0 : x); };
  return {text(v[0]), text(v[1]), text(v[2])};
}

/// "12.5 %", "<0.1 %".
std::string percent(double share);

ExplanationRow row(std::string symbol, std::vector<std::string> values, std::string unit, std::string meaning);
ExplanationRow scalar(std::string symbol, double value, std::string unit, std::string meaning);
template <typename Vector>
ExplanationRow vector(std::string symbol, const Vector& value, std::string unit, std::string meaning) {
  return row(std::move(symbol), numbers(value), std::move(unit), std::move(meaning));
}
/// With a swatch of its colour.
ExplanationRow light(std::string symbol, const glm::vec3& value, std::string meaning);

}  // namespace explained

}  // namespace boxprobe
