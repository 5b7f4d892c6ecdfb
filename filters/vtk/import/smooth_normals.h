// Normals of triangles that come without. Called by the readers of OBJ, PLY, STL and VTP files. Knows no VTK.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Every triangle gets vertices of its own, with unit normals. Triangles meet wherever positions are equal: a corner's
/// normal is the mean, by angle, of those around it that are not turned away from its own by more than 30 degrees.
/// Around a point that more than 64 triangles share, directions within about 10 degrees count as one: the time stays
/// linear in the triangles.
void computeNormals(Mesh& mesh);

}  // namespace boxprobe
