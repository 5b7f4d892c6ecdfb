// Lines of an explanation, and how they are made of values: numbers as text, a scalar, a vector, light. Called by the
// sections and by what sets them; knows no layout.
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
  std::string meaning;               ///< what it is, or the formula with its numbers
  std::optional<glm::vec3> color;    ///< linear light to be shown beside the numbers
  bool marked = false;               ///< this one decides: the smallest slab factor
  bool sum = false;                  ///< what the rows above add up to
  bool detail = false;               ///< belongs to the row above: a texel of a lookup
};

struct ExplanationSection {
  std::string title;
  std::vector<ExplanationRow> rows;
  int probe = -1;  ///< position in Explanation::probes of the one it is about
};

/// "-x" .. "+z" for a ProbeExplanation's face.
std::string boxFaceName(int face);
/// "+X" .. "-Z" for a face of a cubemap in OpenGL's order.
std::string cubeFaceName(int face);

namespace explained {

inline constexpr const char* kLength = "scene units";

/// Components that are only rounding beside the largest are shown as 0.
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
/// With its colour beside the numbers.
ExplanationRow light(std::string symbol, const glm::vec3& value, std::string meaning);

}  // namespace explained

}  // namespace boxprobe
