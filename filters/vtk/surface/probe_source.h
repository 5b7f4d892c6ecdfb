// Our own shader text of the probes that a draw uses: which of our files go in, the switches they are compiled with and
// what stands for each slot. Written for the splice (vtk_pbr_splice.h); knows nothing of the text VTK writes.
#pragma once

#include <string>

#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/surface/surface_output.h"

namespace boxprobe {

/// shaders/gpu/probe_lighting.glsl with the techniques that the binding uses, and no other; `mirror`: a planar mirror's
/// picture is looked up, too; `flatMaps`: maps are flat pictures.
std::string probeDeclarations(const ProbeBinding& binding, SurfaceOutput output, bool mirror, bool flatMaps);

/// What asks how much of a light comes through a probe's coverage; empty where no light asks.
std::string coverageDeclarations(const ProbeBinding& binding);
/// The same of shadow maps: of what moves, and of what stands before suns.
std::string shadowMapDeclarations(const ProbeBinding& binding);

/// Name of the uniform array that holds a number of `row` for each of a draw's probes.
std::string parameterUniform(const ParameterRow& row);

}  // namespace boxprobe
