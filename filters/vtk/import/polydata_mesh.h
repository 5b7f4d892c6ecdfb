// Converts between vtkPolyData and a model's plain arrays.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

class vtkPolyData;

namespace boxprobe {

/// Throws an InputError that starts with `place` for a point that is not finite or beyond 1e18.
void checkPositions(const std::vector<glm::vec3>& positions, const std::string& place);

/// Polygons and strips as triangles, with computed normals if there are none (corners sharper than 30 degrees stay
/// sharp), texture coordinates, and colours from a point array of 8-bit RGB or RGBA (taken as sRGB). Throws an
/// InputError that starts with `place`.
Mesh meshFromPolyData(vtkPolyData* data, const std::string& place);

}  // namespace boxprobe
