// How a surface scatters light, as layered by glTF 2.0 (appendix B) and its extensions: Lambert below a dielectric or a
// metal with GGX microfacets, sheen, a clear coat, sheets and solids of glass. Written from the literature: Walter et
// al. 2007 (microfacets, refraction), Heitz 2014 (masking) and 2018 (visible normals), Estevez and Kulla 2017 (sheen).
//
// A thin film (path_film.h) lies between coat or sheen and base. Not supported, and ignored: a film on a solid of
// glass.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "filters/reference/path/path_surface.h"

namespace boxprobe {

class PathLobes {
 public:
  /// `view`: unit, towards the previous vertex of the path.
  PathLobes(const PathSurface& surface, const glm::dvec3& view);

  /// The reflected share of light from `light` (unit) towards the view, with the cosine; excludes what only sample()
  /// finds: mirrors and transmission.
  glm::dvec3 value(const glm::dvec3& light) const;
  /// The density of sample() over directions, for what value() includes.
  double density(const glm::dvec3& light) const;

  struct Sample {
    glm::dvec3 direction{0.0};  ///< unit
    glm::dvec3 weight{0.0};     ///< value over density
    double density = 0.0;       ///< 0: light sources cannot be sampled for this lobe; see value()
    bool through = false;       ///< to the other side of the surface
  };
  /// `which` selects the lobe. Nothing: the path ends.
  std::optional<Sample> sample(double which, const glm::dvec2& u) const;
  /// Is any lobe included in value()?
  bool scatters() const { return diffuse_ > 0.0 || base_.rough || coat_.rough || sheen_ > 0.0; }

 private:
  struct Facets {
    glm::dmat3 worldFromLocal{1.0};
    glm::dvec3 view{0.0, 0.0, 1.0};  ///< local
    glm::dvec2 alpha{0.0};
    double chance = 0.0;  ///< probability of being sampled
    bool rough = false;   ///< false: a mirror
  };
  static Facets facets(const glm::dvec3& normal, const glm::dvec3& tangent, double roughness, double anisotropy,
                       const glm::dvec3& view);
  static double facetValue(const Facets& f, const glm::dvec3& lightLocal);  ///< D G2 / (4 nv), including the cosine
  static double facetDensity(const Facets& f, const glm::dvec3& lightLocal);
  static glm::dvec3 visibleNormal(const Facets& f, const glm::dvec2& u);

  glm::dvec3 baseFresnel(double vDotH) const;
  glm::dvec3 dielectricFresnel(double vDotH) const;
  /// `plain` with the covered share replaced by a film on a base that reflects `f0`.
  glm::dvec3 filmed(const PathFilm* film, const glm::dvec3& plain, const glm::dvec3& f0, double vDotH) const;
  glm::dvec3 belowBase(double vDotH) const;  ///< of the dielectric's share: what reaches Lambert's law, or passes
  Sample mirrored(const Facets& f, const glm::dvec3& fresnel, double chance) const;
  std::optional<Sample> throughSheet(const glm::dvec2& u, double chance) const;
  std::optional<Sample> throughSolid(double which, const glm::dvec2& u, double chance) const;

  const PathSurface& s_;
  glm::dvec3 view_;
  Facets base_, coat_;
  double diffuse_ = 0.0, sheen_ = 0.0, through_ = 0.0;  ///< probabilities of being sampled
  double belowCoat_ = 1.0, belowSheen_ = 1.0;
  double metal_ = 0.0, glass_ = 0.0;  ///< shares of the base; the rest is an opaque dielectric
};

}  // namespace boxprobe
