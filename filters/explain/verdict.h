// The main fact about a pixel in one sentence and, if there is one, the probe edit that fixes it. `boxprobe explain`
// prints it first; the window's card offers the edit as a button.
#pragma once

#include <optional>
#include <string>

#include "filters/core/scene/scene.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

/// An edit of one probe. It fixes this pixel; the error view shows its effect on others.
struct Mend {
  Phrase words;       ///< description in the imperative: "Move the +x face of \"room\" out by 0.41 m"
  std::string probe;  ///< name of the probe
  Probe after;
};

struct Verdict {
  Phrase sentence;
  std::optional<Mend> mend;
};

/// `scene`: the scene that the pixel was drawn from. Lengths in metres. Angles at the capture origin, between the
/// sampled direction and the reflected ray's hit in the probe's captured distances.
Verdict verdictOf(const Explanation& explanation, const Scene& scene);

}  // namespace boxprobe
