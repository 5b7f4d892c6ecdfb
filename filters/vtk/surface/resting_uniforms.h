// The numbers of a draw that rest between edits (draw/resting_values.h): of the sky and the probes that light it, and
// of its material. Called by the probe pass, which uploads them or draws with a program that has them as constants.
// What goes with the camera, or differs between a capture and the picture by nature, is not among them.
#pragma once

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/resting_values.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/uniform_upload.h"

class vtkProperty;

namespace boxprobe {

/// Of the sky and the slots, as the pass under way sees them: during the first bounce no probe has light of its own.
RestingValues lightingValues(const DrawState& state, const ProbeBinding& binding);

/// Of the material: what VTK uploads from the property (9.1's names), and what our own code does from `surface`.
RestingValues materialValues(const SurfaceMaterial& surface, vtkProperty* property);

/// To the program's uniforms, those of `constants` apart; null: all.
void uploadResting(const UniformUpload& to, const RestingValues& values, const RestingValues* constants);

}  // namespace boxprobe
