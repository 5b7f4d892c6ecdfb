// A material as VTK's own program can show it: for a driver that refuses ours, and to measure ours against. The first
// set of coordinates, untransformed, one wrap mode for both axes, normal maps where the file brings tangents. Called by
// the probe pass and the benchmarks; knows no probes.
#pragma once

#include "filters/vtk/draw/surface_material.h"

class vtkPolyData;
class vtkProperty;

namespace boxprobe {

/// Textures into the property, coordinates and tangents into the data; both keep what else they have.
void givePlainSurface(const SurfaceMaterial& surface, vtkProperty* property, vtkPolyData* data);

}  // namespace boxprobe
