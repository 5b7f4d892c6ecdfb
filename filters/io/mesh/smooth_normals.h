// Computes normals for triangles without them.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Gives each triangle its own vertices with unit normals. Triangles are adjacent where positions are equal: a corner's
/// normal is the angle-weighted mean of the surrounding normals within 30 degrees of its own triangle's. Around a point
/// with more than 64 triangles, directions within about 10 degrees are merged, so that the time stays linear in the
/// number of triangles.
void computeNormals(Mesh& mesh);

}  // namespace boxprobe
