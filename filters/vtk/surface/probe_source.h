// Shader source for the probes of a draw: which files are included, their defines, and the code for each slot.
// vtk_pbr_splice.h inserts it.
#pragma once

#include <string>

#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/surface_output.h"

namespace boxprobe {

/// shaders/gpu/probe_lighting.glsl with the techniques of the binding only; `mirror`: also samples a planar mirror's
/// picture; `flatMaps`: maps are flat pictures.
std::string probeDeclarations(const ProbeBinding& binding, SurfaceOutput output, bool mirror, bool flatMaps);

/// Samples the transmittance of a light through a probe's coverage; empty if no light needs it.
std::string coverageDeclarations(const ProbeBinding& binding);
/// The same of shadow maps: of what moves, and of what stands before suns.
std::string shadowMapDeclarations(const ProbeBinding& binding);

/// Name of the uniform array with the numbers of `row`, one for each of a draw's probes.
std::string parameterUniform(const ParameterRow& row);

}  // namespace boxprobe
