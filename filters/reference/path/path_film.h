// A thin film on a surface, as in KHR_materials_iridescence: the reflections of its two faces interfere. Airy's
// summation (Born and Wolf, Principles of Optics, 7.6) of Fresnel's amplitudes, separately for s and p, per wavelength
// under CIE's D65, seen by the CIE 1931 observer (Wyman, Sloan and Shirley 2013: "Simple Analytic Approximations to the
// CIE XYZ Color Matching Functions"), as linear Rec. 709. Written from these sources; shares no code with what it
// judges.
//
// - The base has a real index for each channel, (1 + sqrt F0) / (1 - sqrt F0), which reflects F0 at normal incidence in
//   air. The extension uses this index for metals as well, since a file does not tell how a metal absorbs. So fringes
//   lie where the author of a file sees them.
// - Without a film, or with one of zero thickness, the base reflects as in air: a dielectric by Fresnel's equations, a
//   metal by Schlick's curve in both polarisations, by which glTF defines metals. A real index as high as a metal's
//   would lose half of the light at its Brewster angle, as no metal does.
// - A flat spectrum is white: a reflectance that is the same at all wavelengths is unchanged.
// - A channel outside Rec. 709 is clamped to 0 or 1.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

class PathFilm {
 public:
  enum class Base { Dielectric, Metal };

  /// `ior` of the film, at least 1; thicknesses in nanometres, clamped to kThickest, beyond which fringes are too many
  /// to be seen.
  PathFilm(Base base, double ior, double leastThickness, double mostThickness);

  /// In air, from a table; `f0` of the base, `cosine` of the angle to the normal in air.
  glm::dvec3 reflectance(const glm::dvec3& f0, double thickness, double cosine) const;

  /// At one wavelength (nanometres), for unpolarised light; indices of film and base at least 1.
  static double atWavelength(Base base, double ior, double baseIor, double thickness, double cosine, double wavelength);

  static constexpr double kThickest = 12000.0;

 private:
  static constexpr int kCosines = 128, kRoots = 33;  ///< nodes: root of the cosine, root of F0

  double least_, step_ = 0.0;  ///< thickness at the first nodes, and between nodes
  int layers_ = 1;
  std::vector<glm::vec3> table_;  ///< by thickness, cosine and root
};

}  // namespace boxprobe
