// Between vtkPolyData, vtkImageData and the plain arrays of a model. Called by the readers of models.
#pragma once

#include <memory>
#include <string>

#include "filters/core/scene/model.h"

class vtkImageData;
class vtkPolyData;

namespace boxprobe {

/// The polygons and strips as triangles, with normals computed where there are none (corners sharper than 30 degrees
/// stay sharp), texture coordinates, and colours if a point array of 8-bit RGB or RGBA is there (taken for sRGB).
/// Throws InputError that starts with `place`.
Mesh meshFromPolyData(vtkPolyData* data, const std::string& place);

/// 8-bit pictures of 1 to 4 components; null for any other.
std::shared_ptr<const ImageRgba8> imageFromVtk(vtkImageData* data, const std::string& name);

}  // namespace boxprobe
