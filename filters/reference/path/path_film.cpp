#include "filters/reference/path/path_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <glm/common.hpp>

namespace boxprobe {

namespace {

constexpr double kWholeTurn = 6.28318530717958647692;
constexpr int kWavelengths = 161;
constexpr double kFirst = 380.0, kStep = 2.5;  // nanometres

/// A Gaussian with different widths on its two sides.
double lobe(double wavelength, double middle, double below, double above) {
  const double t = (wavelength - middle) / (wavelength < middle ? below : above);
  return std::exp(-0.5 * t * t);
}

/// x, y, z of the CIE 1931 observer: the multi-lobe fit.
glm::dvec3 observer(double w) {
  return {1.056 * lobe(w, 599.8, 37.9, 31.0) + 0.362 * lobe(w, 442.0, 16.0, 26.7) - 0.065 * lobe(w, 501.1, 20.4, 26.2),
          0.821 * lobe(w, 568.8, 46.9, 40.5) + 0.286 * lobe(w, 530.9, 16.3, 31.1),
          1.217 * lobe(w, 437.0, 11.8, 36.0) + 0.681 * lobe(w, 459.0, 26.0, 13.8)};
}

/// Relative power of CIE's D65, whose white is that of Rec. 709; linear between every tenth nanometre.
double daylight(double wavelength) {
  static constexpr double kPower[] = {49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812,
                                      114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
                                      100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
                                      80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856,
                                      75.0870, 63.5927, 46.4182, 66.8054, 63.3828};
  const double at = std::clamp((wavelength - 380.0) / 10.0, 0.0, 39.999);
  const auto i = static_cast<std::size_t>(at);
  return kPower[i] + (at - static_cast<double>(i)) * (kPower[i + 1] - kPower[i]);
}

/// Contribution of each wavelength to linear Rec. 709; they sum to white per channel.
const std::array<glm::dvec3, kWavelengths>& weights() {
  static const auto all = [] {
    std::array<glm::dvec3, kWavelengths> w;
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < w.size(); ++i) {
      const double wavelength = kFirst + kStep * static_cast<double>(i);
      const glm::dvec3 c = daylight(wavelength) * observer(wavelength);
      // IEC 61966-2-1, from XYZ.
      w[i] = {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
              0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
      sum += w[i];
    }
    for (glm::dvec3& each : w) each /= sum;
    return w;
  }();
  return all;
}

double amplitude(double a, double b) {
  return a + b > 0.0 ? (a - b) / (a + b) : 0.0;
}

/// The amplitudes of both interfaces for s and p, and the path difference of the second wave.
struct Film {
  double outer[2], inner[2];
  double delay;  ///< nanometres in air

  Film(PathFilm::Base base, double ior, double baseIor, double thickness, double cosine) {
    const double sine2 = 1.0 - cosine * cosine;
    const double within = std::sqrt(1.0 - sine2 / (ior * ior));
    delay = 2.0 * ior * thickness * within;
    outer[0] = amplitude(cosine, ior * within);
    outer[1] = amplitude(ior * cosine, within);
    double inAir[2];  // of the base
    if (base == PathFilm::Base::Metal) {
      const double straight = amplitude(baseIor, 1.0), f0 = straight * straight;
      inAir[1] = std::sqrt(f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0));
      inAir[0] = -inAir[1];
    } else {
      const double below = std::sqrt(1.0 - sine2 / (baseIor * baseIor));
      inAir[0] = amplitude(cosine, baseIor * below);
      inAir[1] = amplitude(baseIor * cosine, below);
    }
    // A base is given by its admittance, and so by its reflectance in air, whatever is on it.
    for (int i = 0; i < 2; ++i) inner[i] = (inAir[i] - outer[i]) / std::max(1.0 - outer[i] * inAir[i], 1e-12);
  }

  /// The sum of all waves that leave; `turned`: the phase factor of one traversal.
  double reflectance(const std::complex<double>& turned) const {
    double sum = 0.0;
    for (int i = 0; i < 2; ++i) {
      const std::complex<double> wave = inner[i] * turned;
      const double left = std::norm(1.0 + outer[i] * wave);
      sum += left > 0.0 ? 0.5 * std::norm(outer[i] + wave) / left : 0.5;
    }
    return sum;
  }
};

std::complex<double> turnedBy(double delay, double wavelength) {
  return std::polar(1.0, kWholeTurn * delay / wavelength);
}

/// F0 = 1 has no finite index.
double indexOf(double rootF0) {
  const double root = std::min(rootF0, 0.99995);
  return (1.0 + root) / (1.0 - root);
}

}  // namespace

double PathFilm::atWavelength(Base base, double ior, double baseIor, double thickness, double cosine,
                              double wavelength) {
  const Film film(base, ior, baseIor, thickness, cosine);
  return film.reflectance(turnedBy(film.delay, wavelength));
}

PathFilm::PathFilm(Base base, double ior, double leastThickness, double mostThickness)
    : least_(std::clamp(leastThickness, 0.0, kThickest)) {
  constexpr double kLayer = 8.0;  // a fifteenth of the finest fringe
  constexpr int kMostLayers = 257;
  const double range = std::clamp(mostThickness, least_, kThickest) - least_;
  if (range > 0.0) {
    layers_ = std::min(static_cast<int>(std::ceil(range / kLayer)) + 1, kMostLayers);
    step_ = range / (layers_ - 1);
  }
  table_.reserve(static_cast<std::size_t>(layers_) * kCosines * kRoots);
  std::array<std::complex<double>, kWavelengths> turned;
  for (int layer = 0; layer < layers_; ++layer) {
    for (int c = 0; c < kCosines; ++c) {
      const double share = static_cast<double>(c) / (kCosines - 1), cosine = share * share;
      const double thickness = least_ + step_ * layer;
      const double delay = Film(base, ior, 1.0, thickness, cosine).delay;
      for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[i] = turnedBy(delay, kFirst + kStep * static_cast<double>(i));
      }
      for (int r = 0; r < kRoots; ++r) {
        const Film film(base, ior, indexOf(static_cast<double>(r) / (kRoots - 1)), thickness, cosine);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < turned.size(); ++i) sum += film.reflectance(turned[i]) * weights()[i];
        table_.emplace_back(sum);
      }
    }
  }
}

glm::dvec3 PathFilm::reflectance(const glm::dvec3& f0, double thickness, double cosine) const {
  struct Place {
    int node;
    double share;
    Place(double at, int nodes) {
      const double within = std::clamp(at, 0.0, static_cast<double>(nodes - 1));
      node = std::min(static_cast<int>(within), std::max(nodes - 2, 0));
      share = within - node;
    }
  };
  const Place layer(step_ > 0.0 ? (thickness - least_) / step_ : 0.0, layers_);
  const Place angle(std::sqrt(std::clamp(cosine, 0.0, 1.0)) * (kCosines - 1), kCosines);
  glm::dvec3 found(0.0);
  for (int channel = 0; channel < 3; ++channel) {
    const Place root(std::sqrt(std::clamp(f0[channel], 0.0, 1.0)) * (kRoots - 1), kRoots);
    for (int i = 0; i < 8; ++i) {
      const double weight = ((i & 1) != 0 ? root.share : 1.0 - root.share) *
                            ((i & 2) != 0 ? angle.share : 1.0 - angle.share) *
                            ((i & 4) != 0 ? layer.share : 1.0 - layer.share);
      if (weight == 0.0) continue;
      const int at = ((layer.node + (i >> 2)) * kCosines + angle.node + ((i >> 1) & 1)) * kRoots + root.node + (i & 1);
      found[channel] += weight * static_cast<double>(table_[static_cast<std::size_t>(at)][channel]);
    }
  }
  return glm::clamp(found, glm::dvec3(0.0), glm::dvec3(1.0));
}

}  // namespace boxprobe
