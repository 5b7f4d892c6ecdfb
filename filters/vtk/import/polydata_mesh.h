// Between vtkPolyData and the plain arrays of a model. Called by the readers of models.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

class vtkPolyData;

namespace boxprobe {

/// Throws InputError that starts with `place` for a point that is not finite or beyond 1e18.
void checkPositions(const std::vector<glm::vec3>& positions, const std::string& place);

/// The polygons and strips as triangles, with normals computed where there are none (corners sharper than 30 degrees
/// stay sharp), texture coordinates, and colours if a point array of 8-bit RGB or RGBA is there (taken for sRGB).
/// Throws InputError that starts with `place`.
Mesh meshFromPolyData(vtkPolyData* data, const std::string& place);

}  // namespace boxprobe
