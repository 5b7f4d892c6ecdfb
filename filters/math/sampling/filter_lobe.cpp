#include "filters/math/sampling/filter_lobe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979324;
// CubeMapGen's cone holds this many standard deviations to either side; the 1.1 % beyond are cut off, as there.
constexpr double kGaussianReach = 3.0;
// Samples are denser than the kernel in its tail, and weigh less there: with a density equal to the kernel (power 2, or
// variance 1) the outermost samples have footprints wider than their distance from the middle.
constexpr double kGgxPower = 1.75;
constexpr double kGaussianSpread = 2.0;
// Added to the level at which a texel covers exactly a sample's share of solid angle: footprints then overlap, so a
// lamp between two samples is not lost. Less gives blotches, more blurs; chosen for the least error over the
// benchmark's cubemaps.
constexpr double kLevelBias = 0.3;
// Variance of a sample's footprint per axis, in texels of its level: 1/4 from the 1 3 3 1 chain, 1/6 from
// interpolation.
constexpr double kFootprintVariance = 0.25 + 1.0 / 6.0;

struct Sample {
  glm::dvec3 direction;
  double density;  // per steradian
};

// Density proportional to (1 + x²)^-power, x = tan(angle(h)) / alpha, up to the horizon, where tan(angle(h)) = 1. GGX's
// D itself has power 2. `share` runs evenly over (0, 1), `azimuth` in turns.
Sample ggxSample(double alpha, double azimuth, double share) {
  const double g = 1.0 - kGgxPower;
  const double atHorizon = std::pow(1.0 + 1.0 / (alpha * alpha), g);
  const double v = std::pow(1.0 - share * (1.0 - atHorizon), 1.0 / g);  // 1 + x²
  const double tangent2 = alpha * alpha * (v - 1.0);
  const double cosine2 = 1.0 / (1.0 + tangent2);
  const double radius = 2.0 * std::sqrt(tangent2) * cosine2, phi = 2.0 * kPi * azimuth;  // sin of twice the angle
  // d(share)/dv over d(solid angle)/dv; the solid angle is 2 pi (1 - z) with z = (1 - tangent2) / (1 + tangent2).
  const double shareByV = -g * std::pow(v, g - 1.0) / (1.0 - atHorizon);
  const double solidAngleByV = 4.0 * kPi * alpha * alpha * cosine2 * cosine2;
  return {{radius * std::cos(phi), radius * std::sin(phi), 2.0 * cosine2 - 1.0}, shareByV / solidAngleByV};
}

// A Gaussian of kGaussianSpread times the variance, over the sphere unrolled to a plane, cut off at kGaussianReach.
Sample gaussianSample(double deviation, double azimuth, double share) {
  const double variance = kGaussianSpread * deviation * deviation;
  const double reach = std::min(kGaussianReach * deviation, 0.5 * kPi);
  const double inside = 1.0 - std::exp(-0.5 * reach * reach / variance);
  const double angle = std::sqrt(-2.0 * variance * std::log1p(-share * inside)), phi = 2.0 * kPi * azimuth;
  const double planeDensity = std::exp(-0.5 * angle * angle / variance) / (2.0 * kPi * variance * inside);
  return {{std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)},
          planeDensity * (angle > 0.0 ? angle / std::sin(angle) : 1.0)};
}

// A group of samples at nearly the same angle.
struct Ring {
  double radius;    // 2 sin(angle / 2): areas in the plane are solid angles on the sphere
  double variance;  // of the footprints, per axis, steradian
  double kernel;    // wanted there, up to a factor common to all rings
  double weight;
};

// exp(-x) I0(x) for x >= 0, to 2e-7: Abramowitz and Stegun, 9.8.1 and 9.8.2.
double scaledBesselI0(double x) {
  if (x < 3.75) {
    const double y = (x / 3.75) * (x / 3.75);
    return std::exp(-x) *
           (1.0 +
            y * (3.5156229 + y * (3.0899424 + y * (1.2067492 + y * (0.2659732 + y * (0.0360768 + y * 0.0045813))))));
  }
  const double y = 3.75 / x;
  return (0.39894228 +
          y * (0.01328592 +
               y * (0.00225319 +
                    y * (-0.00157565 +
                         y * (0.00916281 +
                              y * (-0.02057706 + y * (0.02635537 + y * (-0.01647633 + y * 0.00392377)))))))) /
         std::sqrt(x);
}

// The value at `radius` of a ring of unit weight blurred by round footprints: a Gaussian rotated about the middle.
double blurredRing(const Ring& ring, double radius) {
  const double apart = radius - ring.radius;
  return std::exp(-0.5 * apart * apart / ring.variance) * scaledBesselI0(radius * ring.radius / ring.variance) /
         ring.variance;
}

// Finds weights with which the samples and their footprints together add up to the kernel: each is multiplied by wanted
// over found until they agree (Richardson-Lucy, which keeps weights positive). A few rounds suffice; too many would fit
// the spacing of the rings.
void fitWeights(std::vector<Ring>& rings) {
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> found(rings.size(), 0.0);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      for (const Ring& ring : rings) found[i] += ring.weight * blurredRing(ring, rings[i].radius);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < rings.size(); ++i) sum += rings[i].weight *= rings[i].kernel / found[i];
    for (Ring& ring : rings) ring.weight /= sum;
  }
}

}  // namespace

int prefilterLevels(int faceSize) {
  int levels = 1;
  for (int size = faceSize; size > 4; size /= 2) ++levels;
  return levels;
}

FilterLobe lobeOfLevel(const PrefilterSettings& settings, int level, int maxLevel) {
  if (settings.filter == FilterLobe::Kind::Ggx) {
    const float p = shading::roughnessForLevel(static_cast<float>(level), static_cast<float>(maxLevel));
    return {FilterLobe::Kind::Ggx, p * p};
  }
  // CubeMapGen filters each level from the one before it, so variances add up.
  const GaussianSettings& g = settings.gaussian;
  const auto deviation = [](double coneDegrees) { return 0.5 * coneDegrees * kPi / 180.0 / kGaussianReach; };
  double variance = deviation(g.baseAngleDegrees) * deviation(g.baseAngleDegrees);
  double angle = g.initialMipAngleDegrees;
  for (int i = 1; i <= level; ++i, angle *= g.mipAngleScale) variance += deviation(angle) * deviation(angle);
  return {FilterLobe::Kind::Gaussian, static_cast<float>(std::sqrt(variance))};
}

int samplesOfLevel(const PrefilterSettings& settings, int level) {
  const int first = std::clamp(settings.samples, kMinSamples, kMaxSamples);
  return std::min(first << std::clamp(level - 1, 0, 8), kMaxSamples);
}

float lobeKernel(const FilterLobe& lobe, float oneMinusCosine) {
  if (oneMinusCosine >= 1.0f) return 0.0f;
  const float sine2 = 0.5f * std::max(oneMinusCosine, 0.0f);  // of half the angle
  if (lobe.kind == FilterLobe::Kind::Ggx) {
    const float q = sine2 + lobe.width * lobe.width * (1.0f - sine2);
    const float r = lobe.width / std::max(q, 1.0e-30f);
    return r * r * (1.0f - oneMinusCosine);
  }
  const float angle = 2.0f * std::asin(std::sqrt(sine2));
  if (angle > static_cast<float>(kGaussianReach) * lobe.width) return 0.0f;
  return std::exp(-0.5f * angle * angle / (lobe.width * lobe.width));
}

std::vector<LobeTap> lobeTaps(const FilterLobe& lobe, int count, int sourceFaceSize) {
  constexpr int kRings = 64;
  const double texelSolidAngle = 4.0 * kPi / (6.0 * sourceFaceSize * sourceFaceSize);
  const int perRing = (count + kRings - 1) / kRings;
  std::vector<LobeTap> taps;
  std::vector<Ring> rings;
  for (int i = 0; i < count; ++i) {
    const double azimuth = std::fmod(i * 0.6180339887498949, 1.0);
    const double share = (i + 0.5) / count;
    const bool ggx = lobe.kind == FilterLobe::Kind::Ggx;
    const Sample s = ggx ? ggxSample(lobe.width, azimuth, share) : gaussianSample(lobe.width, azimuth, share);
    const double solidAngle = 1.0 / (count * s.density);
    const double level = std::max(0.5 * std::log2(solidAngle / texelSolidAngle) + kLevelBias, 0.0);
    const double kernel = lobeKernel(lobe, static_cast<float>(1.0 - s.direction.z));
    taps.push_back({glm::vec3(s.direction), static_cast<float>(level), static_cast<float>(kernel * solidAngle)});
    if (i % perRing == 0) rings.push_back({0.0, 0.0, 0.0, 0.0});
    Ring& ring = rings.back();
    ring.weight += kernel * solidAngle;
    if (i % perRing != perRing / 2 && i != count - 1) continue;
    if (ring.variance > 0.0) continue;
    ring.radius = std::sqrt(2.0 * (1.0 - s.direction.z));
    ring.kernel = kernel;
    // Interpolation of the capture itself does not count: it belongs to the picture that is blurred. The variance is
    // never less than what fills the gaps between samples that are denser than texels.
    ring.variance = std::max((std::exp2(2.0 * level) - 1.0) * kFootprintVariance * texelSolidAngle, 0.3 * solidAngle);
  }
  std::vector<double> before;
  for (const Ring& ring : rings) before.push_back(ring.weight);
  fitWeights(rings);
  double sum = 0.0;
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const std::size_t ring = i / static_cast<std::size_t>(perRing);
    taps[i].weight = static_cast<float>(taps[i].weight * rings[ring].weight / before[ring]);
    sum += taps[i].weight;
  }
  for (LobeTap& tap : taps) tap.weight = static_cast<float>(tap.weight / sum);
  return taps;
}

}  // namespace boxprobe
