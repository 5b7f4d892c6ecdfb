// The letters that formulas have, at their places in a picture: P, N, R, H, C and the lookup. Called by the lesson
// photographer where a step draws rays.
#pragma once

#include <QImage>

#include "filters/explain/explanation.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

/// Of one ray on a box; nothing where the pixel shows none.
void drawRayLetters(QImage& picture, const Explanation& explanation, const ViewProjection& view);

}  // namespace boxprobe
