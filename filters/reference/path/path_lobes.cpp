#include "filters/reference/path/path_lobes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

namespace {

constexpr double kCoatF0 = 0.04;       // KHR_materials_clearcoat: an index of 1.5
constexpr double kMirrorAlpha = 1e-4;  // below it a lobe counts as a mirror

double fifth(double x) {
  const double c = std::clamp(1.0 - x, 0.0, 1.0);
  return c * c * c * c * c;
}

double mean(const glm::dvec3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

/// Lambda of Smith's masking for GGX (Heitz 2014), anisotropic.
double lambda(const glm::dvec3& w, const glm::dvec2& alpha) {
  const double z2 = w.z * w.z;
  if (z2 <= 0.0) return 1e30;
  const double slope2 = (alpha.x * alpha.x * w.x * w.x + alpha.y * alpha.y * w.y * w.y) / z2;
  return 0.5 * (std::sqrt(1.0 + slope2) - 1.0);
}

double distribution(const glm::dvec3& h, const glm::dvec2& alpha) {
  const double x = h.x / alpha.x, y = h.y / alpha.y, d = x * x + y * y + h.z * h.z;
  return 1.0 / (kPathPi * alpha.x * alpha.y * d * d);
}

glm::dvec2 disc(const glm::dvec2& u) {
  const double r = std::sqrt(u.x), phi = 2.0 * kPathPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

glm::dmat3 frameOf(const glm::dvec3& normal, const glm::dvec3& tangent) {
  glm::dvec3 x = tangent - glm::dot(tangent, normal) * normal;
  if (glm::length(x) < 1e-9) x = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  x = glm::normalize(x - glm::dot(x, normal) * normal);
  return {x, glm::cross(normal, x), normal};
}

/// Unpolarised reflectance of an interface; `eta`: index behind it over the index in front.
double dielectric(double cosine, double eta) {
  const double c = std::clamp(std::abs(cosine), 0.0, 1.0), sine2 = (1.0 - c * c) / (eta * eta);
  if (sine2 >= 1.0) return 1.0;
  const double t = std::sqrt(1.0 - sine2);
  const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return 0.5 * (s * s + p * p);
}

/// Sheen: Estevez and Kulla's distribution with Ashikhmin's visibility, as in KHR_materials_sheen.
double clothValue(double nh, double nv, double nl, double roughness) {
  const double alpha = std::max(roughness * roughness, 1e-3), sine = std::sqrt(std::max(1.0 - nh * nh, 0.0));
  const double d = (2.0 + 1.0 / alpha) * std::pow(sine, 1.0 / alpha) / (2.0 * kPathPi);
  return d * nl / (4.0 * (nl + nv - nl * nv));
}

/// Directional albedo of sheen by view and roughness, integrated here once.
class ClothAlbedo {
 public:
  ClothAlbedo() {
    constexpr int kSteps = 48;
    for (int r = 0; r < kSize; ++r) {
      for (int v = 0; v < kSize; ++v) {
        const double nv = (v + 0.5) / kSize, roughness = (r + 0.5) / kSize, sine = std::sqrt(1.0 - nv * nv);
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
          for (int k = 0; k < kSteps; ++k) {
            const double nl = (i + 0.5) / kSteps, phi = kPathPi * (k + 0.5) / kSteps;
            const glm::dvec3 l(std::sqrt(1.0 - nl * nl) * std::cos(phi), std::sqrt(1.0 - nl * nl) * std::sin(phi), nl);
            const glm::dvec3 h = glm::normalize(l + glm::dvec3(sine, 0.0, nv));
            sum += clothValue(h.z, nv, nl, roughness);
          }
        }
        values_[static_cast<std::size_t>(r * kSize + v)] = std::min(sum * 2.0 * kPathPi / (kSteps * kSteps), 1.0);
      }
    }
  }
  double at(double nv, double roughness) const {
    const double x = std::clamp(nv * kSize - 0.5, 0.0, kSize - 1.001),
                 y = std::clamp(roughness * kSize - 0.5, 0.0, kSize - 1.001);
    const int c = static_cast<int>(x), r = static_cast<int>(y);
    const double a = x - c, b = y - r;
    const auto value = [&](int row, int column) { return values_[static_cast<std::size_t>(row * kSize + column)]; };
    return (1 - a) * (1 - b) * value(r, c) + a * (1 - b) * value(r, c + 1) + (1 - a) * b * value(r + 1, c) +
           a * b * value(r + 1, c + 1);
  }

 private:
  static constexpr int kSize = 32;
  std::array<double, kSize * kSize> values_{};
};

const ClothAlbedo& clothAlbedo() {
  static const ClothAlbedo table;
  return table;
}

}  // namespace

PathLobes::Facets PathLobes::facets(const glm::dvec3& normal, const glm::dvec3& tangent, double roughness,
                                    double anisotropy, const glm::dvec3& view) {
  Facets f;
  f.worldFromLocal = frameOf(normal, tangent);
  f.view = glm::transpose(f.worldFromLocal) * view;
  f.view.z = std::max(f.view.z, 1e-4);  // interpolated normals may face away from the viewer
  f.view = glm::normalize(f.view);
  const double alpha = roughness * roughness;
  // KHR_materials_anisotropy: along the tangent mix(alpha, 1, strength squared), across it alpha.
  f.alpha = {alpha + (1.0 - alpha) * anisotropy * anisotropy, alpha};
  f.rough = f.alpha.y >= kMirrorAlpha;
  return f;
}

PathLobes::PathLobes(const PathSurface& surface, const glm::dvec3& view) : s_(surface), view_(view) {
  base_ = facets(s_.normal, s_.tangent, s_.roughness, s_.anisotropy, view);
  metal_ = s_.metallic;
  glass_ = (1.0 - s_.metallic) * s_.transmission;
  const double nv = base_.view.z;
  if (s_.coat > 0.0) {
    coat_ = facets(s_.coatNormal, s_.tangent, s_.coatRoughness, 0.0, view);
    belowCoat_ = 1.0 - s_.coat * (kCoatF0 + (1.0 - kCoatF0) * fifth(coat_.view.z));
  }
  const double sheen = largestOf(s_.sheen);
  if (sheen > 0.0) belowSheen_ = 1.0 - std::min(sheen * clothAlbedo().at(nv, s_.sheenRoughness), 1.0);

  // Probabilities roughly proportional to each lobe's light towards the view.
  const double reflected = mean(baseFresnel(nv));
  base_.chance =
      std::max(reflected, s_.specularEdge > 0.0 || s_.f0 > 0.0 || metal_ > 0.0 || s_.filmShare > 0.0 ? 0.1 : 0.0);
  diffuse_ = (1.0 - metal_) * (1.0 - s_.transmission) * mean(s_.color);
  through_ = glass_ * std::max(mean(s_.color), 0.05);
  coat_.chance = s_.coat > 0.0 ? std::max(1.0 - belowCoat_, 0.1) : 0.0;
  sheen_ = sheen > 0.0 ? std::max(1.0 - belowSheen_, 0.1) : 0.0;
  // The interface of a solid is only sampled: reflection and transmission together.
  if (!s_.thin && glass_ > 0.0) {
    through_ += glass_ * base_.chance;
    base_.chance *= 1.0 - glass_;
  }
  const double all = base_.chance + diffuse_ + through_ + coat_.chance + sheen_;
  if (all <= 0.0) return;
  for (double* chance : {&base_.chance, &diffuse_, &through_, &coat_.chance, &sheen_}) *chance /= all;
}

glm::dvec3 PathLobes::baseFresnel(double vDotH) const {
  // A transmitting solid has its own interface.
  const double plainShare = 1.0 - metal_ - (s_.thin ? 0.0 : glass_);
  glm::dvec3 sum(0.0);
  if (metal_ > 0.0) {
    sum += metal_ * filmed(s_.metalFilm, s_.color + (glm::dvec3(1.0) - s_.color) * fifth(vDotH), s_.color, vDotH);
  }
  if (plainShare > 0.0) sum += plainShare * glm::max(dielectricFresnel(vDotH), glm::dvec3(0.0));
  return sum;
}

glm::dvec3 PathLobes::dielectricFresnel(double vDotH) const {
  const glm::dvec3 f0 = glm::min(s_.f0 * s_.specularTint, glm::dvec3(1.0));
  return filmed(s_.film, f0 + (glm::dvec3(s_.specularEdge) - f0) * fifth(vDotH), f0, vDotH);
}

glm::dvec3 PathLobes::filmed(const PathFilm* film, const glm::dvec3& plain, const glm::dvec3& f0, double vDotH) const {
  if (film == nullptr || s_.filmShare <= 0.0) return plain;
  return glm::mix(plain, film->reflectance(f0, s_.filmThickness, vDotH), s_.filmShare);
}

glm::dvec3 PathLobes::belowBase(double vDotH) const {
  // KHR_materials_specular: what a tint removes from one channel does not become diffuse light of another.
  return glm::dvec3(1.0 - std::clamp(largestOf(dielectricFresnel(vDotH)), 0.0, 1.0));
}

double PathLobes::facetValue(const Facets& f, const glm::dvec3& l) {
  if (!f.rough || l.z <= 0.0) return 0.0;
  const glm::dvec3 h = glm::normalize(f.view + l);
  if (h.z <= 0.0) return 0.0;
  return distribution(h, f.alpha) / (1.0 + lambda(f.view, f.alpha) + lambda(l, f.alpha)) / (4.0 * f.view.z);
}

double PathLobes::facetDensity(const Facets& f, const glm::dvec3& l) {
  if (!f.rough || l.z <= 0.0) return 0.0;
  const glm::dvec3 h = glm::normalize(f.view + l);
  if (h.z <= 0.0) return 0.0;
  return distribution(h, f.alpha) / (1.0 + lambda(f.view, f.alpha)) / (4.0 * f.view.z);
}

/// Heitz 2018: a point of the projected hemisphere of the stretched view.
glm::dvec3 PathLobes::visibleNormal(const Facets& f, const glm::dvec2& u) {
  const glm::dvec3 v = glm::normalize(glm::dvec3(f.alpha.x * f.view.x, f.alpha.y * f.view.y, f.view.z));
  const double across = v.x * v.x + v.y * v.y;
  const glm::dvec3 x = across > 0.0 ? glm::dvec3(-v.y, v.x, 0.0) / std::sqrt(across) : glm::dvec3(1, 0, 0);
  const glm::dvec3 y = glm::cross(v, x);
  const glm::dvec2 p = disc(u);
  const double s = 0.5 * (1.0 + v.z);
  const double q = (1.0 - s) * std::sqrt(std::max(1.0 - p.x * p.x, 0.0)) + s * p.y;
  const glm::dvec3 h = p.x * x + q * y + std::sqrt(std::max(1.0 - p.x * p.x - q * q, 0.0)) * v;
  return glm::normalize(glm::dvec3(f.alpha.x * h.x, f.alpha.y * h.y, std::max(h.z, 0.0)));
}

glm::dvec3 PathLobes::value(const glm::dvec3& light) const {
  glm::dvec3 sum(0.0);
  const glm::dvec3 l = glm::transpose(base_.worldFromLocal) * light;
  if (l.z > 0.0) {
    const glm::dvec3 h = glm::normalize(base_.view + l);
    const double vh = std::max(glm::dot(base_.view, h), 0.0);
    sum += facetValue(base_, l) * baseFresnel(vh);
    const double lambert = (1.0 - metal_) * (1.0 - s_.transmission) * l.z / kPathPi;
    sum += lambert * s_.color * belowBase(vh);
    sum *= belowSheen_;
    if (sheen_ > 0.0) sum += s_.sheen * clothValue(h.z, base_.view.z, l.z, s_.sheenRoughness);
    sum *= belowCoat_;
  }
  if (s_.thin && glass_ > 0.0 && l.z < 0.0 && base_.rough) {
    const glm::dvec3 mirroredLight(l.x, l.y, -l.z);
    const glm::dvec3 h = glm::normalize(base_.view + mirroredLight);
    sum += belowCoat_ * belowSheen_ * glass_ * s_.color * facetValue(base_, mirroredLight) *
           belowBase(std::max(glm::dot(base_.view, h), 0.0));
  }
  if (s_.coat > 0.0) {
    const glm::dvec3 c = glm::transpose(coat_.worldFromLocal) * light;
    if (c.z > 0.0) {
      const glm::dvec3 h = glm::normalize(coat_.view + c);
      sum += glm::dvec3(s_.coat * facetValue(coat_, c) *
                        (kCoatF0 + (1.0 - kCoatF0) * fifth(std::max(glm::dot(coat_.view, h), 0.0))));
    }
  }
  return sum;
}

double PathLobes::density(const glm::dvec3& light) const {
  const glm::dvec3 l = glm::transpose(base_.worldFromLocal) * light;
  double sum = base_.chance * facetDensity(base_, l) + (diffuse_ + sheen_) * std::max(l.z, 0.0) / kPathPi;
  if (s_.thin && through_ > 0.0 && base_.rough) sum += through_ * facetDensity(base_, {l.x, l.y, -l.z});
  if (coat_.chance > 0.0) sum += coat_.chance * facetDensity(coat_, glm::transpose(coat_.worldFromLocal) * light);
  return sum;
}

PathLobes::Sample PathLobes::mirrored(const Facets& f, const glm::dvec3& fresnel, double chance) const {
  Sample s;
  s.direction = f.worldFromLocal * glm::dvec3(-f.view.x, -f.view.y, f.view.z);
  s.weight = fresnel / chance;
  return s;
}

/// Smooth sheets, straight through. Rough sheets are in value().
std::optional<PathLobes::Sample> PathLobes::throughSheet(const glm::dvec2& u, double chance) const {
  if (base_.rough) {
    const glm::dvec3 h = visibleNormal(base_, u);
    const glm::dvec3 l = 2.0 * glm::dot(base_.view, h) * h - base_.view;
    if (l.z <= 0.0) return std::nullopt;
    Sample s;
    s.direction = base_.worldFromLocal * glm::dvec3(l.x, l.y, -l.z);
    s.through = true;
    return s;  // weighted with the others
  }
  Sample s;
  s.direction = -view_;
  s.weight = belowCoat_ * belowSheen_ * glass_ * s_.color * belowBase(base_.view.z) / chance;
  s.through = true;
  return s;
}

/// One facet of the interface, which reflects or refracts by Fresnel's equations (Walter et al. 2007).
std::optional<PathLobes::Sample> PathLobes::throughSolid(double which, const glm::dvec2& u, double chance) const {
  const glm::dvec3 h = base_.rough ? visibleNormal(base_, u) : glm::dvec3(0.0, 0.0, 1.0);
  const double eta = s_.inside ? 1.0 / s_.ior : s_.ior, cosine = std::clamp(glm::dot(base_.view, h), 0.0, 1.0);
  const double reflectance = dielectric(cosine, eta);
  glm::dvec3 l;
  Sample s;
  if (which < reflectance) {
    l = 2.0 * cosine * h - base_.view;
    if (l.z <= 0.0) return std::nullopt;
    s.weight = glm::dvec3(1.0);
  } else {
    const double t = std::sqrt(std::max(1.0 - (1.0 - cosine * cosine) / (eta * eta), 0.0));
    l = (cosine / eta - t) * h - base_.view / eta;
    if (l.z >= 0.0) return std::nullopt;
    // The base colour tints light that enters, not light that leaves.
    s.weight = s_.inside ? glm::dvec3(1.0) : s_.color;
    s.through = true;
  }
  if (base_.rough) {
    // What remains of the masking with visible normals: G2 over G1, uncorrelated behind the surface.
    const double v = 1.0 + lambda(base_.view, base_.alpha), o = lambda({l.x, l.y, std::abs(l.z)}, base_.alpha);
    s.weight *= s.through ? 1.0 / (1.0 + o) : v / (v + o);
  }
  s.direction = base_.worldFromLocal * glm::normalize(l);
  s.weight *= glass_ * belowCoat_ * belowSheen_ / chance;
  return s;
}

std::optional<PathLobes::Sample> PathLobes::sample(double which, const glm::dvec2& u) const {
  Sample s;
  if (which < base_.chance) {
    if (!base_.rough) return mirrored(base_, belowCoat_ * belowSheen_ * baseFresnel(base_.view.z), base_.chance);
    const glm::dvec3 h = visibleNormal(base_, u);
    const glm::dvec3 l = 2.0 * glm::dot(base_.view, h) * h - base_.view;
    if (l.z <= 0.0) return std::nullopt;
    s.direction = base_.worldFromLocal * l;
  } else if ((which -= base_.chance) < coat_.chance) {
    if (!coat_.rough) {
      const double fresnel = kCoatF0 + (1.0 - kCoatF0) * fifth(coat_.view.z);
      return mirrored(coat_, glm::dvec3(s_.coat * fresnel), coat_.chance);
    }
    const glm::dvec3 h = visibleNormal(coat_, u);
    const glm::dvec3 l = 2.0 * glm::dot(coat_.view, h) * h - coat_.view;
    if (l.z <= 0.0) return std::nullopt;
    s.direction = coat_.worldFromLocal * l;
  } else if ((which -= coat_.chance) < through_) {
    if (!s_.thin) return throughSolid(which / through_, u, through_);
    const auto straight = throughSheet(u, through_);
    if (!straight || !base_.rough) return straight;
    s = *straight;
  } else {
    const glm::dvec2 p = disc(u);
    s.direction = base_.worldFromLocal * glm::dvec3(p, std::sqrt(std::max(1.0 - p.x * p.x - p.y * p.y, 0.0)));
  }
  s.direction = glm::normalize(s.direction);
  s.density = density(s.direction);
  if (!(s.density > 0.0)) return std::nullopt;
  s.weight = value(s.direction) / s.density;
  return s;
}

}  // namespace boxprobe
