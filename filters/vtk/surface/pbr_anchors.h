// The lines of VTK's physically based shading that the splice (vtk_pbr_splice.h) edits, as tables. Applied in order: a
// later row may edit the replacement of an earlier one.
#pragma once

#include <vector>

namespace boxprobe {

/// Occurs in every physically based fragment shader of VTK 9.1, and in no other.
constexpr const char* kPbrMark = "vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;";

struct Anchor {
  const char* what;
  std::vector<const char*> texts;         // forms in VTK: without and with its own image-based lighting
  std::vector<const char*> replacements;  // one for each text, or one for all
  bool coatOnly;
};

const std::vector<Anchor>& viewAndOutputAnchors();
const std::vector<Anchor>& emissionAnchors();
const std::vector<Anchor>& materialAnchors();
const std::vector<Anchor>& tableAnchors();
const std::vector<Anchor>& lightingAnchors();
const std::vector<Anchor>& maskingAnchors();
const std::vector<Anchor>& coatAnchors();
const std::vector<Anchor>& scatteringAnchors();
const std::vector<Anchor>& glassAnchors();
/// For programs that draw lamps as shapes in reflections.
const std::vector<Anchor>& lampAnchors();

}  // namespace boxprobe
