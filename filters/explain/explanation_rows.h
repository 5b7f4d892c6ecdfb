// Lines of an explanation from values: numbers as text, a scalar, a vector, light. Called by the sections; internal to
// this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/base/fixed_text.h"
#include "filters/explain/explanation_sections.h"

namespace boxprobe::explained {

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

}  // namespace boxprobe::explained
