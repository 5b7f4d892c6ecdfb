// A material approximated by VTK's own program: if the driver refuses ours, and to compare with ours. Uses the first
// set of texture coordinates without transform, one wrap mode for both axes, and normal maps if the file has tangents.
#pragma once

#include "filters/vtk/draw/surface_material.h"

class vtkPolyData;
class vtkProperty;

namespace boxprobe {

/// Adds textures to the property, and coordinates and tangents to the data; both keep their other values.
void applyPlainSurface(const SurfaceMaterial& surface, vtkProperty* property, vtkPolyData* data);

}  // namespace boxprobe
