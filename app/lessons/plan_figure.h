// The plan and the elevation of a lesson's pixel in its page: as a still drawing, and as the numbers from which
// data/web/plan.js draws the same to take hold of. Plain text; knows no Qt.
#pragma once

#include <string>

#include "filters/explain/explanation.h"

namespace boxprobe {

/// Is there a box to draw? What the others ask for.
bool hasPlan(const Explanation& explanation);

/// {"position", "normal", "eye", "origin", "box": {"min", "max"}, "elevation": "front" | "side"}: scene units along the
/// box's axes from the world's origin.
std::string planJson(const Explanation& explanation);

/// Two figures of inline SVG with the classes of data/web/page.css.
std::string planSvg(const Explanation& explanation);

}  // namespace boxprobe
