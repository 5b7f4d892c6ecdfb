#include "filters/io/cube/sky_sun.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "filters/io/cube/picture_repair.h"
#include "filters/io/cube/picture_sphere.h"

namespace boxprobe {

namespace {

// Chosen for what suns are in photographs, before any picture was measured.
constexpr double kEdge = 1.0 / 64.0;       // of the brightest texel: where the disc ends
constexpr double kWidest = 3.5;            // degrees in radius; a wider one throws no shadow that a sun's map can draw
constexpr double kAround = 7.0;            // degrees around the centre that are to be dark against it
constexpr double kMostAround = 0.02;       // of its light
constexpr double kContrast = 256.0;        // over the mean, of one that half floats hold
constexpr double kLeastShare = 1.0 / 8.0;  // of what the rest gives a surface that faces it

struct Texel {
  std::size_t at = 0;
  glm::dvec3 direction{0.0};
  double light = 0.0;  ///< brightest channel times solid angle
};

template <typename Sphere>
class SunFinder {
 public:
  explicit SunFinder(const Sphere& sphere) : sphere_(sphere) {}

  std::optional<SkySun> take() {
    if (!findBrightest() || !findDisc()) return std::nullopt;
    const glm::dvec3 around = lightAround();
    // What each texel has beyond the light around it.
    std::vector<glm::dvec3> excess;
    glm::dvec3 vector(0.0), irradiance(0.0);
    double light = 0.0, cubed = 0.0, fourth = 0.0;
    for (const Texel& texel : disc_) {
      const float* rgba = sphere_.rgba(texel.at);
      const glm::dvec3 own(rgba[0], rgba[1], rgba[2]);
      excess.push_back(own - glm::min(own, around));
      const double most = std::max({excess.back().x, excess.back().y, excess.back().z});
      const double share = most * sphere_.solidAngle(texel.at);
      vector += share * texel.direction;
      light += share;
      // Relative to the brightest, so that no power overflows.
      const double of = most / peak_;
      cubed += sphere_.solidAngle(texel.at) * of * of * of;
      fourth += sphere_.solidAngle(texel.at) * of * of * of * of;
    }
    if (!(glm::length(vector) > 0.0) || !(fourth > 0.0)) return std::nullopt;
    SkySun sun;
    sun.towards = glm::normalize(vector);
    for (std::size_t i = 0; i < disc_.size(); ++i) {
      irradiance += sphere_.solidAngle(disc_[i].at) * glm::dot(disc_[i].direction, sun.towards) * excess[i];
    }
    const double rest = mean_ - light / (4.0 * kSpherePi);
    const double most = std::max({irradiance.x, irradiance.y, irradiance.z});
    if (!(most < 1.0e30)) return std::nullopt;
    if (!(peak_ > kHalfMax) && most < kLeastShare * kSpherePi * rest) return std::nullopt;
    sun.irradiance = glm::vec3(irradiance);
    // By the radiance of its brighter part: texels on its edge are darker than it is.
    const double angle = light / (peak_ * fourth / cubed);
    sun.angleDegrees = glm::degrees(2.0 * std::acos(std::clamp(1.0 - angle / (2.0 * kSpherePi), -1.0, 1.0)));
    for (std::size_t i = 0; i < disc_.size(); ++i) {
      float* rgba = sphere_.rgba(disc_[i].at);
      for (int c = 0; c < 3; ++c) rgba[c] = std::min(rgba[c], static_cast<float>(around[c]));
    }
    return sun;
  }

 private:
  bool findBrightest() {
    double sum = 0.0;
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      const float value = brightestChannel(sphere_.rgba(i));
      sum += value * sphere_.solidAngle(i);
      if (value > peak_) {
        peak_ = value;
        brightest_ = i;
      }
    }
    mean_ = sum / (4.0 * kSpherePi);
    return peak_ > kHalfMax || (mean_ > 0.0 && peak_ > kContrast * mean_);
  }

  std::vector<Texel> brightTexels(const glm::dvec3& center, double degrees) const {
    std::vector<Texel> found;
    const double cosine = std::cos(glm::radians(degrees));
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      const float value = brightestChannel(sphere_.rgba(i));
      if (!(value > edge_)) continue;
      const glm::dvec3 direction = sphere_.direction(i);
      if (glm::dot(direction, center) >= cosine) found.push_back({i, direction, value * sphere_.solidAngle(i)});
    }
    return found;
  }

  bool findDisc() {
    edge_ = std::max(std::min(peak_ * kEdge, static_cast<double>(kHalfMax)), 4.0 * mean_);
    if (!(peak_ > edge_)) return false;
    // From the brightest texel, which may be at the edge of an even disc, to the middle of the light around it.
    glm::dvec3 center(0.0);
    for (const Texel& texel : brightTexels(sphere_.direction(brightest_), kAround)) {
      center += texel.light * texel.direction;
    }
    if (!(glm::length(center) > 0.0)) return false;
    center_ = glm::normalize(center);
    const double inside = std::cos(glm::radians(kWidest) + 0.5 * sphere_.pitch());
    double light = 0.0, beyond = 0.0;
    for (const Texel& texel : brightTexels(center_, kAround + glm::degrees(sphere_.pitch()))) {
      if (glm::dot(texel.direction, center_) < inside) {
        beyond += texel.light;
        continue;
      }
      light += texel.light;
      disc_.push_back(texel);
      radius_ = std::max(radius_, std::acos(std::clamp(glm::dot(texel.direction, center_), -1.0, 1.0)));
    }
    // Of a coarse picture even one texel may be too wide.
    double angle = 0.0;
    for (const Texel& texel : disc_) angle += sphere_.solidAngle(texel.at);
    const bool small = angle <= 2.0 * kSpherePi * (1.0 - std::cos(glm::radians(kWidest)));
    return !disc_.empty() && small && beyond <= kMostAround * light;
  }

  /// The mean of what is next to the disc.
  glm::dvec3 lightAround() const {
    const double cosine = std::cos(radius_ + std::max(glm::radians(1.0), 2.0 * sphere_.pitch()));
    glm::dvec3 sum(0.0);
    double angle = 0.0;
    for (std::size_t i = 0; i < sphere_.count; ++i) {
      const float* rgba = sphere_.rgba(i);
      if (brightestChannel(rgba) > edge_ || glm::dot(sphere_.direction(i), center_) < cosine) continue;
      sum += sphere_.solidAngle(i) * glm::dvec3(rgba[0], rgba[1], rgba[2]);
      angle += sphere_.solidAngle(i);
    }
    return angle > 0.0 ? sum / angle : glm::dvec3(0.0);
  }

  const Sphere& sphere_;
  double peak_ = 0.0, mean_ = 0.0, edge_ = 0.0, radius_ = 0.0;
  std::size_t brightest_ = 0;
  glm::dvec3 center_{0.0};
  std::vector<Texel> disc_;
};

template <typename Sphere>
std::optional<SkySun> takeFrom(const Sphere& sphere, std::size_t& beyondHalf) {
  std::optional<SkySun> sun = SunFinder<Sphere>(sphere).take();
  if (!sun || beyondHalf == 0) return sun;
  std::size_t left = 0;
  for (std::size_t i = 0; i < sphere.count; ++i) left += brightestChannel(sphere.rgba(i)) > kHalfMax ? 1 : 0;
  beyondHalf = left;
  return sun;
}

}  // namespace

std::optional<SkySun> takeSun(ImageRgbaF& latLong, std::size_t& beyondHalf) {
  return takeFrom(LatLongSphere(latLong), beyondHalf);
}

std::optional<SkySun> takeSun(CubeMap& cube, std::size_t& beyondHalf) {
  return takeFrom(CubeSphere(cube), beyondHalf);
}

Light lightOf(const SkySun& sun, double skyRotationDegrees) {
  const double turn = glm::radians(std::remainder(skyRotationDegrees, 360.0));
  const double cosine = std::cos(turn), sine = std::sin(turn);
  const glm::dvec3& t = sun.towards;
  Light light;
  light.type = LightType::Directional;
  light.direction = -glm::dvec3(cosine * t.x + sine * t.z, t.y, cosine * t.z - sine * t.x);
  light.intensity = std::max({sun.irradiance.x, sun.irradiance.y, sun.irradiance.z});
  light.color = sun.irradiance / light.intensity;
  light.angleDegrees = sun.angleDegrees;
  return light;
}

}  // namespace boxprobe
