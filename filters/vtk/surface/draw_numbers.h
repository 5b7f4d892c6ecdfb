// The numbers of a draw that stay the same between edits: of the sky and the probes that light it, and of its material.
// Uploaded, or constants of a program that is made for them (draw/constants.h). What goes with the camera, or differs
// between a capture and the picture by nature, is not among them.
#pragma once

#include "filters/vtk/draw/constants.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/uniform_upload.h"

class vtkProperty;

namespace boxprobe {

/// Of the sky and the slots, as the pass under way sees them: during the first bounce no probe has light of its own.
void readLighting(NumberReader& to, const DrawState& state, const ProbeBinding& binding);

/// Of the material: what VTK uploads from the property (9.1's names), and what our own code does from `surface`.
void readMaterial(NumberReader& to, const SurfaceMaterial& surface, vtkProperty* property);

/// Into the program's uniforms, those of `constants` apart; null: all.
class NumberUpload : public NumberReader {
 public:
  NumberUpload(const UniformUpload& to, const Constants* constants) : to_(to), constants_(constants) {}
  void read(const char* name, int components, const float* values, std::size_t count) override;

 private:
  const UniformUpload& to_;
  const Constants* constants_;
};

}  // namespace boxprobe
