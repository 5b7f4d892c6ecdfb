// What decides a pixel, in one sentence, and the edit of a probe that would mend it where there is one. Stands first in
// what `boxprobe explain` prints and on the window's card, which offers the edit as a button. Plain values; reads the
// scene and changes nothing.
#pragma once

#include <optional>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// An edit of one probe. It mends this pixel: whether it serves the others, the error view shows.
struct Mend {
  std::string words;  ///< what it does, in the imperative: "Move the +x face of \"room\" out by 0.41 m"
  std::string probe;  ///< by its name
  Probe after;
};

struct Verdict {
  std::string sentence;
  std::optional<Mend> mend;
};

/// `scene`: what the pixel was drawn from. Lengths in metres; angles as seen from the capture origin, between where the
/// technique looks and where the probe's captured distances have the reflected ray's hit.
Verdict verdictOf(const Explanation& explanation, const Scene& scene);

}  // namespace boxprobe
