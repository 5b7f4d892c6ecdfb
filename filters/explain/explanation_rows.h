// Rows of an explanation, formatted from values: scalars, vectors, light.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/fixed_text.h"
#include "filters/core/base/phrase.h"

namespace boxprobe {

struct ExplanationRow {
  Phrase symbol;                     ///< a word, or "P", "t_x": what follows an underscore is a subscript
  std::vector<std::string> numbers;  ///< none, one or three
  std::string unit;                  ///< "" for a pure number
  Phrase meaning;                    ///< description, or the formula with its numbers
  std::optional<glm::vec3> color;    ///< linear light, shown as a swatch
  bool marked = false;               ///< decisive: the smallest slab factor
  bool sum = false;                  ///< the sum of the rows above
  bool detail = false;               ///< belongs to the row above: a texel of a lookup
};

struct ExplanationSection {
  Phrase title;
  std::vector<ExplanationRow> rows;
  int probe = -1;  ///< index in Explanation::probes of the section's probe
};

/// "-x" .. "+z" for a ProbeExplanation's face.
std::string boxFaceName(int face);
/// A row's number, which may be a word: "infinite".
Phrase numberPhrase(const std::string& number);
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

/// Letters are the same in every language; words are translated.
struct Symbol : Phrase {
  Symbol(const char* letters) : Phrase(plain(letters)) {}
  Symbol(std::string letters) : Phrase(plain(std::move(letters))) {}
  Symbol(Phrase word) : Phrase(std::move(word)) {}
};

ExplanationRow row(Symbol symbol, std::vector<std::string> values, std::string unit, Phrase meaning);
ExplanationRow scalar(Symbol symbol, double value, std::string unit, Phrase meaning);
template <typename Vector>
ExplanationRow vector(Symbol symbol, const Vector& value, std::string unit, Phrase meaning) {
  return row(std::move(symbol), numbers(value), std::move(unit), std::move(meaning));
}
/// With a swatch of its colour.
ExplanationRow light(Symbol symbol, const glm::vec3& value, Phrase meaning);

}  // namespace explained

}  // namespace boxprobe
