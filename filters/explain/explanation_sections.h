// The calculation of a pixel as what is said of it, line by line: symbols, formulas with the numbers put in, units,
// meanings. The text of `boxprobe explain` and the window's card both set these lines, so that they say the same.
// Plain values; knows no layout.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/explain/explanation.h"

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

struct ExplanationDetail {
  /// Of each lookup, the texels with the largest shares; the rest is summed up in one line.
  std::size_t texelsPerLookup = 8;
  /// A probe's lookups are all shown up to this many; of more, the brightest few, and the rest in one line.
  std::size_t lookupsPerProbe = 16;
  std::size_t lookupsOfMany = 4;
  /// Light of a texel, where the caller holds the probe's map; may be empty.
  std::function<std::optional<glm::vec3>(const ProbeExplanation&, const TexelShare&)> texelValue;
};

/// Pixel, surface, each probe, the sky, the sum. Notes are left to the caller: they come first.
std::vector<ExplanationSection> explanationSections(const Explanation& e, const ExplanationDetail& detail = {});

/// "-x" .. "+z" for a ProbeExplanation's face.
std::string boxFaceName(int face);
/// "+X" .. "-Z" for a face of a cubemap in OpenGL's order.
std::string cubeFaceName(int face);

/// Largest difference of a component between computed and rendered colour, relative to the brightest texel fetched (to
/// the colour itself where nothing was fetched); nothing if the pixel was not drawn.
std::optional<float> relativeDifference(const Explanation& e);

}  // namespace boxprobe
