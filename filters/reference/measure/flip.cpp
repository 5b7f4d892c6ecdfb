#include "filters/reference/measure/flip.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;

// A picture in some colour space; a kernel of 2 radius + 1 values along one axis.
struct Plane {
  int width, height;
  std::vector<glm::dvec3> pixels;
};
using Kernel = std::vector<double>;

// Linear RGB of sRGB's primaries to CIE XYZ (IEC 61966-2-1), columns R, G, B; white is its image of (1, 1, 1).
const glm::dmat3 kXyzFromRgb(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750,
                             0.9503041);
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1.0);

// YyCxCz: like L*a*b* without its cube root (section 4.1 of the paper).
glm::dvec3 opponentFromRgb(const glm::dvec3& rgb) {
  const glm::dvec3 r = kXyzFromRgb * rgb / kWhite;
  return {116.0 * r.y - 16.0, 500.0 * (r.x - r.y), 200.0 * (r.y - r.z)};
}
glm::dvec3 rgbFromOpponent(const glm::dvec3& o) {
  static const glm::dmat3 rgbFromXyz = glm::inverse(kXyzFromRgb);
  const double y = (o.x + 16.0) / 116.0;
  return rgbFromXyz * (glm::dvec3(y + o.y / 500.0, y, y - o.z / 200.0) * kWhite);
}

// L*a*b* with the Hunt effect: colours count for less where it is dark.
glm::dvec3 huntLab(const glm::dvec3& rgb) {
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  };
  const glm::dvec3 r = kXyzFromRgb * rgb / kWhite;
  const double lightness = 116.0 * f(r.y) - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f(r.x) - f(r.y)), 0.01 * lightness * 200.0 * (f(r.y) - f(r.z))};
}

// Abasi, Tehran and Fairchild 2020.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// Each component has its own kernels; the border is clamped.
Plane filtered(const Plane& in, const Kernel* const across[3], const Kernel* const down[3]) {
  Plane half = in, out = in;
  const auto pass = [](const Plane& from, Plane& to, const Kernel* const kernels[3], bool vertical) {
    for (int y = 0; y < from.height; ++y) {
      for (int x = 0; x < from.width; ++x) {
        glm::dvec3 sum(0.0);
        for (int c = 0; c < 3; ++c) {
          const Kernel& kernel = *kernels[c];
          const int radius = static_cast<int>(kernel.size() / 2);
          for (int i = -radius; i <= radius; ++i) {
            const int column = vertical ? x : std::clamp(x + i, 0, from.width - 1);
            const int row = vertical ? std::clamp(y + i, 0, from.height - 1) : y;
            sum[c] += kernel[static_cast<std::size_t>(i + radius)] *
                      from.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(from.width) +
                                  static_cast<std::size_t>(column)][c];
          }
        }
        to.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(from.width) + static_cast<std::size_t>(x)] =
            sum;
      }
    }
  };
  pass(in, half, across, false);
  pass(half, out, down, true);
  return out;
}

// The contrast sensitivity of a channel as a sum of Gaussians a sqrt(pi/b) exp(-pi² x²/b), x in degrees (table 1).
struct Gaussian {
  double a, b;
};

struct SensitivityTerm {
  Kernel kernel;  // sums to 1
  double share;   // of the channel's filter
};

SensitivityTerm sensitivityTerm(const Gaussian& g, double pixelsPerDegree, int radius) {
  SensitivityTerm term{Kernel(static_cast<std::size_t>(2 * radius + 1)), 0.0};
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    const double x = i / pixelsPerDegree;
    sum += term.kernel[static_cast<std::size_t>(i + radius)] = std::exp(-kPi * kPi * x * x / g.b);
  }
  for (double& k : term.kernel) k /= sum;
  term.share = g.a * std::sqrt(kPi / g.b) * sum * sum;
  return term;
}

// The picture after the eye's blur, in linear RGB clamped to the display's range.
Plane seen(const Plane& opponent, double pixelsPerDegree) {
  constexpr Gaussian kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053}, kBlue1{34.1, 0.04}, kBlue2{13.5, 0.025};
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kBlue1.b / (2.0 * kPi * kPi)) * pixelsPerDegree));
  const SensitivityTerm luma = sensitivityTerm(kAchromatic, pixelsPerDegree, radius);
  const SensitivityTerm red = sensitivityTerm(kRedGreen, pixelsPerDegree, radius);
  const SensitivityTerm blue1 = sensitivityTerm(kBlue1, pixelsPerDegree, radius);
  const SensitivityTerm blue2 = sensitivityTerm(kBlue2, pixelsPerDegree, radius);
  // Gaussians are separable, their sum is not: the second Gaussian of blue-yellow takes a separate pass.
  const Kernel* const first[3] = {&luma.kernel, &red.kernel, &blue1.kernel};
  const Kernel* const second[3] = {&blue2.kernel, &blue2.kernel, &blue2.kernel};
  Plane result = filtered(opponent, first, first);
  const Plane rest = filtered(opponent, second, second);
  const double share = blue1.share / (blue1.share + blue2.share);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    glm::dvec3& o = result.pixels[i];
    o.z = share * o.z + (1.0 - share) * rest.pixels[i].z;
    o = glm::clamp(rgbFromOpponent(o), 0.0, 1.0);
  }
  return result;
}

// Strength of edges (x) and points (y) in the luminance, by first and second derivatives of a Gaussian (section 4.3).
std::vector<glm::dvec2> features(const Plane& opponent, double pixelsPerDegree) {
  constexpr double kFeatureDegrees = 0.082;
  const double sigma = 0.5 * kFeatureDegrees * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  const auto size = static_cast<std::size_t>(2 * radius + 1);
  Kernel smooth(size), edge(size), point(size);
  for (int i = -radius; i <= radius; ++i) {
    const auto k = static_cast<std::size_t>(i + radius);
    const double t = i / sigma;
    smooth[k] = std::exp(-0.5 * t * t);
    edge[k] = -i * smooth[k];
    point[k] = (t * t - 1.0) * smooth[k];
  }
  // Positive weights sum to 1, negative ones to -1, those of a smoothing kernel to 1.
  for (Kernel* kernel : {&smooth, &edge, &point}) {
    double positive = 0.0, negative = 0.0;
    for (const double k : *kernel) (k > 0.0 ? positive : negative) += std::abs(k);
    for (double& k : *kernel) k /= k > 0.0 ? positive : std::max(negative, 1.0e-300);
  }
  Plane luminance = opponent;
  for (glm::dvec3& p : luminance.pixels) p = glm::dvec3((p.x + 16.0) / 116.0);
  // Components: edges across, points across, unused; then the same down.
  const Kernel* const derived[3] = {&edge, &point, &smooth};
  const Kernel* const smoothed[3] = {&smooth, &smooth, &smooth};
  const Plane across = filtered(luminance, derived, smoothed), down = filtered(luminance, smoothed, derived);
  std::vector<glm::dvec2> result(luminance.pixels.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const glm::dvec3 &x = across.pixels[i], &y = down.pixels[i];
    result[i] = {std::hypot(x.x, y.x), std::hypot(x.y, y.y)};
  }
  return result;
}

Plane opponentOf(const ImageRgbaF& image) {
  Plane plane{image.width, image.height, {}};
  plane.pixels.reserve(image.pixels.size() / 4);
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    glm::dvec3 rgb;
    for (int c = 0; c < 3; ++c) {
      const double x = image.pixels[i + static_cast<std::size_t>(c)];
      rgb[c] = std::isinf(x) && x > 0.0 ? 1.0 : x > 0.0 ? x / (1.0 + x) : 0.0;
    }
    plane.pixels.push_back(opponentFromRgb(rgb));
  }
  return plane;
}

// Maps small differences to most of the range, so that a few huge ones do not hide them (section 4.2).
double colorError(double difference) {
  constexpr double kExponent = 0.7, kCut = 0.4, kShare = 0.95;
  static const double largest =
      std::pow(hyab(huntLab(glm::dvec3(0.0, 1.0, 0.0)), huntLab(glm::dvec3(0.0, 0.0, 1.0))), kExponent);
  const double d = std::pow(difference, kExponent), cut = kCut * largest;
  return d < cut ? kShare * d / cut : kShare + (d - cut) / (largest - cut) * (1.0 - kShare);
}

}  // namespace

std::vector<float> flipMap(const ImageRgbaF& picture, const ImageRgbaF& reference, double pixelsPerDegree) {
  const Plane a = opponentOf(picture), b = opponentOf(reference);
  const Plane seenA = seen(a, pixelsPerDegree), seenB = seen(b, pixelsPerDegree);
  const std::vector<glm::dvec2> featuresA = features(a, pixelsPerDegree), featuresB = features(b, pixelsPerDegree);
  std::vector<float> map(a.pixels.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double color = std::min(colorError(hyab(huntLab(seenA.pixels[i]), huntLab(seenB.pixels[i]))), 1.0);
    const glm::dvec2 difference = glm::abs(featuresA[i] - featuresB[i]);
    const double feature = std::sqrt(std::min(std::max(difference.x, difference.y) / std::sqrt(2.0), 1.0));
    map[i] = static_cast<float>(std::pow(color, 1.0 - feature));
  }
  return map;
}

}  // namespace boxprobe
