// The values of a draw that stay the same between edits: of its probes, the sky and its material. They are uploaded, or
// constants of a specialized program (draw/constants.h). Excludes values that depend on the camera, or on whether it is
// a capture.
#pragma once

#include "filters/vtk/draw/constants.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/uniform_upload.h"

class vtkProperty;

namespace boxprobe {

/// Of the sky and the slots, as seen by the current pass: in the first bounce probes have no light.
void readLighting(NumberReader& to, const DrawState& state, const ProbeBinding& binding);

/// Of the material: what VTK uploads from the property (with 9.1's names), and what our code reads from `surface`.
void readMaterial(NumberReader& to, const SurfaceMaterial& surface, vtkProperty* property);

/// Uploads to the program's uniforms, except those in `constants`; null: all.
class NumberUpload : public NumberReader {
 public:
  NumberUpload(const UniformUpload& to, const Constants* constants) : to_(to), constants_(constants) {}
  void read(const char* name, int components, const float* values, std::size_t count) override;

 private:
  const UniformUpload& to_;
  const Constants* constants_;
};

}  // namespace boxprobe
