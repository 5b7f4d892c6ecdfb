// The form of the footprint techniques with its constants open: what the fit varies. The constants of a form, in the
// order of its comments, become a technique to judge and the text of its file in shaders/technique.
#pragma once

#include <string>
#include <vector>

#include "filters/reference/study/study_tally.h"

namespace boxprobe::bench {

/// What a form of two or more lookups has beside, for surfaces that reflect less straight on: the last of its
/// constants, 0 at first.
constexpr std::size_t kEdgeConstants = 11;

struct FootprintForm {
  std::vector<double> start;
  std::function<study::Technique(const std::vector<double>& constants)> technique;
  /// Residuals that keep the constants plain: pieces of much the same size (one far sharper than the others would show
  /// as a ghost in a blurred reflection), and what the data does not decide at 0.
  std::function<std::vector<double>(const std::vector<double>& constants)> plain;
  /// The lines between `{` and `}` of its evaluation function.
  std::function<std::string(const std::vector<double>& constants)> shader;
};

/// For 1, 2, 4, 8 or 16 lookups.
FootprintForm footprintForm(int lookups);

}  // namespace boxprobe::bench
