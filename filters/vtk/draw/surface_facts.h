// Properties of a material that make part of a surface program's work unnecessary. The splice omits that part; the
// choice here limits the number of programs. Facts are not numbers: dragging a slider only changes uniforms, unless it
// reaches or leaves the end of its range.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/draw/surface_material.h"

class vtkProperty;

namespace boxprobe {

enum SurfaceFact : unsigned {
  kNoMetal = 1u,     ///< metalness 0 everywhere
  kAllMetal = 2u,    ///< metalness 1 everywhere: no diffuse reflection
  kSmooth = 4u,      ///< roughness 0 everywhere, and no coat: lamps have no highlight, the split sum is Fresnel's term
  kNoEmission = 8u,  ///< no emission
  kNeverDiscarded = 16u,         ///< no pixel is fully transparent or cut out, so that the depth test can run early
  kEmissionIsBase = 32u,         ///< base colour and emission share a texture, sampled once
  kOcclusionInRoughMetal = 64u,  ///< likewise occlusion, roughness and metalness
  kPlainUv = 128u,               ///< no texture has a coordinate transform
  kQuickOutput = 256u,           ///< display colours may be off by 1/20 of a step: always, except to compare with VTK
};
using SurfaceFacts = unsigned;  ///< of SurfaceFact
constexpr SurfaceFacts kAnyFact = ~0u;

/// The facts that hold for the material now; none for glass, whose program needs everything.
SurfaceFacts surfaceFacts(const SurfaceMaterial& surface, vtkProperty* property);

/// One object: the key of its program without facts (equal strings share one), and its facts.
struct FactUse {
  std::string program;
  SurfaceFacts facts = 0;
};

/// The facts for which each object's program is made, in the order of `uses`. Facts that all objects of a program share
/// need no further program. Beyond that, programs are divided where most objects gain most, up to half as many again.
/// O(n log n) in the number of objects.
std::vector<SurfaceFacts> planFacts(const std::vector<FactUse>& uses);

}  // namespace boxprobe
