// What a surface's program may take for granted: properties of a material that make part of the calculation constant.
// The probe pass asks which hold, the splice leaves out what they make needless, and what is chosen here keeps the
// number of programs down. No fact is a number of the material, so that dragging a slider changes uniforms; only a
// slider that leaves or reaches the end of its range asks for another program.
#pragma once

#include <string>
#include <vector>

#include "filters/vtk/draw/surface_material.h"

class vtkProperty;

namespace boxprobe {

enum SurfaceFact : unsigned {
  kNoMetal = 1u,     ///< metalness 0 all over
  kAllMetal = 2u,    ///< metalness 1 all over: no diffuse reflection
  kSmooth = 4u,      ///< roughness 0 all over, and no coat: lamps leave no highlight, the split sum is Fresnel's term
  kNoEmission = 8u,  ///< shines with nothing of its own
  kNeverDiscarded = 16u,  ///< no pixel is wholly transparent or cut out, so that depth is settled before the colour is
  kEmissionIsBase = 32u,  ///< one texture for base colour and emission, looked up once
  kOcclusionInRoughMetal = 64u,  ///< likewise for occlusion, roughness and metalness
  kPlainUv = 128u,               ///< no texture has a transform of its coordinates
  kQuickOutput = 256u,  ///< display colours may be a twentieth of a step off: always, but for comparisons with VTK's
};
using SurfaceFacts = unsigned;  ///< of SurfaceFact
constexpr SurfaceFacts kAnyFact = ~0u;

/// Those that hold for the material as it is now; none for glass, whose program needs it all.
SurfaceFacts surfaceFacts(const SurfaceMaterial& surface, vtkProperty* property);

/// One object: what its program is apart from facts (equal strings share one), and the facts that hold for it.
struct FactUse {
  std::string program;
  SurfaceFacts facts = 0;
};

/// Which facts each object's program may be made for, in the order of `uses`. Those that all objects of a program share
/// cost no further program; beyond that programs are divided where most objects gain most, up to half as many again as
/// there are without facts. O(n log n) in the number of objects.
std::vector<SurfaceFacts> planFacts(const std::vector<FactUse>& uses);

}  // namespace boxprobe
