// Puts probe lighting into the fragment shader VTK's polydata mapper has written for physically based shading. The only
// file that knows the text of VTK's surface shader: every anchor, the check that each one matched, the versions it was
// tried on.
#pragma once

#include <string>

#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/surface_output.h"

namespace boxprobe {

/// The shaders of one program as VTK has written them.
struct ShaderSources {
  std::string vertex;
  std::string geometry;  ///< empty unless VTK draws edges
  std::string fragment;
};

/// Edits them in place; `mirror`: a planar mirror's picture is looked up, by a surface that has probes; `surface` may
/// be null: then the material is VTK's own. Returns an empty string, or one line naming VTK's version and the anchor
/// that is not there (the sources are then unchanged). A shader without physically based shading (no light, lines,
/// points) has nothing to splice and is left as it is.
std::string splicePbr(ShaderSources& sources, const ProbeBinding& binding, const SurfaceMaterial* surface,
                      SurfaceOutput output = SurfaceOutput::Picture, bool mirror = false,
                      LightForm form = LightForm::Single);

}  // namespace boxprobe
