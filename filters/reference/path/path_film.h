// A thin film on a surface, as KHR_materials_iridescence has it: what both of its faces reflect interferes. Airy's
// summation (Born and Wolf, Principles of Optics, 7.6) of Fresnel's amplitudes, s and p apart, wavelength by wavelength
// under CIE's D65, seen by the CIE 1931 observer (Wyman, Sloan and Shirley 2013: "Simple Analytic Approximations to the
// CIE XYZ Color Matching Functions"), as linear Rec. 709. Written from these; no code is shared with what it judges.
//
// - The base has a real index for each channel, (1 + sqrt F0) / (1 - sqrt F0), which reflects F0 straight on into air:
//   the extension takes this index, metal or not, since a file does not tell how a metal absorbs. So the fringes lie
//   where its author sees them.
// - Without a film, or one of no thickness, the base reflects what it does in air: a dielectric by Fresnel's equations,
//   a metal by Schlick's curve in both polarisations, by which glTF defines metals. A real index as high as a metal's
//   would lose half of the light at its Brewster angle, as no metal does.
// - An even spectrum is white: a reflectance that is the same at all wavelengths stays what it is.
// - A channel beyond what Rec. 709 can show is cut to 0 or 1.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

class PathFilm {
 public:
  enum class Base { Dielectric, Metal };

  /// `ior` of the film, at least 1; thicknesses in nanometres. What is thicker than kThickest counts as that: its
  /// fringes are too many for an eye.
  PathFilm(Base base, double ior, double leastThickness, double mostThickness);

  /// In air, from a table; `f0` of the base, `cosine` of the angle to the normal in air.
  glm::dvec3 reflectance(const glm::dvec3& f0, double thickness, double cosine) const;

  /// At one wavelength (nanometres), for light that is not polarised; indices of film and base at least 1.
  static double atWavelength(Base base, double ior, double baseIor, double thickness, double cosine, double wavelength);

  static constexpr double kThickest = 12000.0;

 private:
  static constexpr int kCosines = 128, kRoots = 33;  ///< nodes: root of the cosine, root of F0

  double least_, step_ = 0.0;  ///< thickness of the first layer of nodes, and between two
  int layers_ = 1;
  std::vector<glm::vec3> table_;  ///< by thickness, cosine and root
};

}  // namespace boxprobe
