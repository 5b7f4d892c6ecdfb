// The reflection lobe of a rough surface: visible half vectors of GGX, in double precision, for both references. The
// real-time techniques have their own, single-precision forms in shaders/, which this one judges and so shares nothing
// with.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace boxprobe {

/// Low-discrepancy points of [0, 1)²: the R2 sequence (Roberts 2018, inverse powers of the plastic number), shifted by
/// an offset from the seed. Sets of different seeds are independent, so the spread of their results gives the error of
/// their mean (randomized quasi-Monte Carlo).
class ShiftedPoints {
 public:
  explicit ShiftedPoints(std::uint64_t seed);
  glm::dvec2 operator[](int index) const;

 private:
  glm::dvec2 shift_;
};

/// Hashes `value` (the finalizer of splitmix64), for seeds from pixel numbers.
std::uint64_t hashBits(std::uint64_t value);

class VisibleNormalLobe {
 public:
  /// `normal` and `view` (towards the eye) are unit vectors in one frame; alpha = perceptual roughness². A view from
  /// below the surface, which interpolated normals produce, counts as grazing.
  VisibleNormalLobe(const glm::dvec3& normal, const glm::dvec3& view, double alpha);

  /// For a brushed surface, rougher along one direction than across it: `across` is a unit vector perpendicular to
  /// `normal`; alphas at least 1e-4.
  VisibleNormalLobe(const glm::dvec3& normal, const glm::dvec3& across, const glm::dvec3& view, double alphaAlong,
                    double alphaAcross);

  struct Sample {
    glm::dvec3 direction;  ///< unit, away from the surface
    double weight;         ///< G2 / G1: f cos over probability density, without the Fresnel factor; 0 below the surface
    double hDotV;          ///< cosine between half vector and view, for the Fresnel factor
  };
  /// Heitz 2018, "Sampling the GGX Distribution of Visible Normals"; height-correlated Smith masking. `u` in [0, 1)².
  Sample sample(const glm::dvec2& u) const;

  /// The same for a given direction (unit), for other sampling strategies; `density`: that of sample() per solid angle,
  /// 0 below the surface. NaN for a mirror.
  struct Density {
    double density = 0.0;
    double weight = 0.0;
    double hDotV = 0.0;
  };
  Density at(const glm::dvec3& direction) const;

  /// The same surface and view with at least this alpha.
  VisibleNormalLobe widened(double alpha) const;

  /// So narrow that every sample is the mirrored view.
  bool mirror() const { return alpha_ < 1.0e-6; }

 private:
  Sample sampleBrushed(const glm::dvec2& u) const;
  Density brushedAt(const glm::dvec3& direction) const;
  double brushedRoot(const glm::dvec3& direction) const;

  glm::dvec3 normal_, tangent_, bitangent_;  ///< tangent and bitangent of a brushed surface: along and across
  glm::dvec3 mirrored_;
  double alpha_, sine_, cosine_;
  double stretchedX_, stretchedZ_;  ///< the view stretched to where microfacets form a hemisphere
  double alphaAlong_ = 0.0;         ///< of a brushed surface, whose alpha_ is that across; else 0
  glm::dvec3 view_{0.0};            ///< of a brushed surface, in its axes
  double viewRoot_;                 ///< sqrt(alpha² + (1 - alpha²) cos²) of the view
};

/// The reflection of `radiance(direction)` by the lobe: the integral of D, G2 and the microfacets'
/// `reflectance(hDotV)`, estimated per ray. Weights are not normalised: constant light gives the lobe's albedo, and the
/// estimate is unbiased for any number of rays.
template <typename Reflectance, typename Radiance>
glm::dvec3 lobeReflected(const VisibleNormalLobe& lobe, int rays, std::uint64_t seed, const Reflectance& reflectance,
                         const Radiance& radiance) {
  const ShiftedPoints points(seed);
  const int count = lobe.mirror() ? 1 : rays;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i) {
    const VisibleNormalLobe::Sample s = lobe.sample(points[i]);
    if (s.weight > 0.0) sum += s.weight * reflectance(s.hDotV) * radiance(s.direction);
  }
  return sum / static_cast<double>(count);
}

/// The mean of `radiance(direction)` over the lobe, weighted by masking and Schlick's Fresnel from `f0` to `f90`, per
/// component. Weights are normalised, so a constant is returned exactly. This is what a technique's lookups
/// approximate, and what the renderer multiplies by the lobe's albedo. The quotient is biased, less with more rays
/// (about a hundredth of the lobe's contrast with 8 rays at roughness 1). A component that reflects nothing gives 0.
template <typename Radiance>
glm::dvec3 lobeMean(const VisibleNormalLobe& lobe, const glm::dvec3& f0, const glm::dvec3& f90, int rays,
                    std::uint64_t seed, const Radiance& radiance) {
  const ShiftedPoints points(seed);
  glm::dvec3 sum(0.0), weights(0.0);
  const int count = lobe.mirror() ? 1 : rays;
  // At grazing views half of the directions point into the surface: tries a few more to find some.
  constexpr int kSpare = 64;
  for (int i = 0; i < count || (i < count + kSpare && weights == glm::dvec3(0.0)); ++i) {
    const VisibleNormalLobe::Sample s = lobe.sample(points[i]);
    if (s.weight <= 0.0) continue;
    const double grazing = 1.0 - s.hDotV, square = grazing * grazing;
    const glm::dvec3 weight = s.weight * (f0 + (f90 - f0) * (square * square * grazing));
    sum += weight * radiance(s.direction);
    weights += weight;
  }
  glm::dvec3 mean(0.0);
  for (int c = 0; c < 3; ++c) mean[c] = weights[c] > 0.0 ? sum[c] / weights[c] : 0.0;
  return mean;
}

}  // namespace boxprobe
