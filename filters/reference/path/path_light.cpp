#include "filters/reference/path/path_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>

namespace boxprobe {

namespace {

double brightness(const glm::dvec3& c) {
  return std::max((c.x + c.y + c.z) / 3.0, 0.0);
}

glm::dvec3 across(const glm::dvec3& n) {
  return glm::normalize(glm::cross(std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), n));
}

/// Uniform over a cone around `axis`; `cosine`: of half its angle.
glm::dvec3 inCone(const glm::dvec3& axis, double cosine, const glm::dvec2& u) {
  const double z = 1.0 - u.x * (1.0 - cosine), r = std::sqrt(std::max(1.0 - z * z, 0.0)), phi = 2.0 * kPathPi * u.y;
  const glm::dvec3 x = across(axis), y = glm::cross(axis, x);
  return glm::normalize(r * std::cos(phi) * x + r * std::sin(phi) * y + z * axis);
}

/// 1 - cos of half the angle under which a sphere is seen; accurate for small angles.
double coneHeight(double radius, double distance) {
  const double s2 = std::min(radius * radius / (distance * distance), 1.0);
  return s2 / (1.0 + std::sqrt(1.0 - s2));
}

/// Mean emission of a material, from some texels of its texture.
glm::dvec3 meanEmission(const Material& material) {
  glm::dvec3 mean(1.0);
  if (const auto& image = material.emissiveTexture.image; image && image->pixels.size() >= 4) {
    const std::size_t texels = image->pixels.size() / 4, stride = std::max<std::size_t>(1, texels / 4099);
    mean = glm::dvec3(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i < texels; i += stride, count += 1.0) {
      for (int c = 0; c < 3; ++c) mean[c] += std::pow(image->pixels[4 * i + static_cast<std::size_t>(c)] / 255.0, 2.2);
    }
    mean /= count;
  }
  // A little for textures that look black by these texels: every triangle that may emit must be sampled.
  return glm::dvec3(material.emissive) * glm::max(mean, glm::dvec3(1.0e-3));
}

}  // namespace

DiscreteDistribution::DiscreteDistribution(const std::vector<double>& weights) {
  double sum = 0.0;
  sums_.reserve(weights.size());
  for (const double weight : weights) sums_.push_back(sum += std::isfinite(weight) ? std::max(weight, 0.0) : 0.0);
}

std::size_t DiscreteDistribution::at(double& u) const {
  const double wanted = u * sums_.back();
  auto found = std::upper_bound(sums_.begin(), sums_.end(), wanted);
  if (found == sums_.end()) --found;
  const auto i = static_cast<std::size_t>(found - sums_.begin());
  const double before = i > 0 ? sums_[i - 1] : 0.0;
  u = std::clamp((wanted - before) / (sums_[i] - before), 0.0, 1.0 - 1e-12);
  return i;
}

PathSky::PathSky(const Scene& scene, std::shared_ptr<const ImageRgbaF> image)
    : sky_(scene.sky),
      image_(std::move(image)),
      turn_(glm::radians(scene.skyRotationDegrees)),
      cells_(std::vector<double>()) {
  // Cells of equal solid angle: rows of equal height, since the area of a sphere's zone is proportional to its height.
  std::vector<double> weights;
  const int fine = image_ ? 4 : 1;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      double sum = 0.0;
      for (int i = 0; i < fine * fine; ++i) {
        const double y = 1.0 - 2.0 * (row + (i / fine + 0.5) / fine) / kRows;
        const double phi = 2.0 * kPathPi * (column + (i % fine + 0.5) / fine) / kColumns, r = std::sqrt(1.0 - y * y);
        sum += brightness(radiance({r * std::sin(phi), y, r * std::cos(phi)}));
      }
      weights.push_back(sum / (fine * fine));
      mean_ += weights.back() / (kRows * kColumns);
    }
  }
  // A bright spot may lie between the samples.
  if (mean_ > 0.0) {
    for (double& weight : weights) weight += 0.02 * mean_;
  }
  cells_ = DiscreteDistribution(weights);
}

double PathSky::cellAngle() const {
  return 4.0 * kPathPi / (kRows * kColumns);
}

glm::dvec3 PathSky::radiance(const glm::dvec3& direction) const {
  if (const auto* color = std::get_if<SkyColor>(&sky_)) return glm::dvec3(color->color);
  if (const auto* gradient = std::get_if<SkyGradient>(&sky_)) {
    const double y = direction.y;
    return glm::mix(glm::dvec3(gradient->horizon), glm::dvec3(y < 0.0 ? gradient->ground : gradient->top), std::abs(y));
  }
  if (!image_ || image_->width <= 0 || image_->height <= 0) return glm::dvec3(0.0);
  const double longitude = std::atan2(direction.x, direction.z) - turn_;
  const double x = (0.5 - longitude / (2.0 * kPathPi)) * image_->width - 0.5;
  const double y = std::acos(std::clamp(direction.y, -1.0, 1.0)) / kPathPi * image_->height - 0.5;
  const double column = std::floor(x), row = std::floor(y), a = x - column, b = y - row;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    const int w = image_->width, c = ((static_cast<int>(column) + (i & 1)) % w + w) % w;
    const int r = std::clamp(static_cast<int>(row) + (i >> 1), 0, image_->height - 1);
    const float* p =
        &image_->pixels[4 * (static_cast<std::size_t>(r) * static_cast<std::size_t>(w) + static_cast<std::size_t>(c))];
    const double weight = ((i & 1) != 0 ? a : 1.0 - a) * ((i & 2) != 0 ? b : 1.0 - b);
    for (int k = 0; k < 3; ++k) sum[k] += std::isfinite(p[k]) ? weight * p[k] : 0.0;
  }
  return sum;
}

glm::dvec3 PathSky::sample(const glm::dvec2& u, double& density) const {
  double within = u.x;
  const std::size_t cell = cells_.at(within);
  const auto row = static_cast<double>(cell / kColumns), column = static_cast<double>(cell % kColumns);
  const double y = 1.0 - 2.0 * (row + within) / kRows, phi = 2.0 * kPathPi * (column + u.y) / kColumns;
  const double r = std::sqrt(std::max(1.0 - y * y, 0.0));
  density = cells_.share(cell) / cellAngle();
  return {r * std::sin(phi), y, r * std::cos(phi)};
}

double PathSky::density(const glm::dvec3& direction) const {
  if (cells_.empty()) return 0.0;
  const double row = std::clamp(0.5 * (1.0 - direction.y) * kRows, 0.0, kRows - 1.0);
  const double phi = std::atan2(direction.x, direction.z) / (2.0 * kPathPi);
  const double column = std::clamp((phi - std::floor(phi)) * kColumns, 0.0, kColumns - 1.0);
  return cells_.share(static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)) / cellAngle();
}

PathLights::PathLights(const Scene& scene, const PathScene& triangles, std::shared_ptr<const ImageRgbaF> skyImage)
    : scene_(triangles),
      sky_(scene, std::move(skyImage)),
      byPower_(std::vector<double>()),
      kinds_(std::vector<double>()) {
  const TriangleScene& all = triangles.scene();
  std::vector<double> power;
  lampOf_.resize(all.objects.size());
  for (std::size_t o = 0; o < all.objects.size(); ++o) {
    const TracedObject& object = all.objects[o];
    if (!object.inPicture) continue;
    if (object.material.unlit) unlit_ = unlit_ || glm::vec3(object.material.baseColor) != glm::vec3(0.0f);
    if (object.material.emissive == glm::vec3(0.0f) || object.material.unlit) continue;
    const double shines = brightness(meanEmission(object.material));
    lampOf_[o].assign(object.indices.size() / 3, -1);
    for (std::size_t t = 0; 3 * t + 2 < object.indices.size(); ++t) {
      const auto at = [&](std::size_t k) { return glm::dvec3(object.positions[object.indices[3 * t + k]]); };
      Lamp lamp;
      lamp.object = static_cast<int>(o);
      lamp.triangle = static_cast<std::uint32_t>(t);
      lamp.corner = at(0);
      lamp.along = at(1) - at(0);
      lamp.up = at(2) - at(0);
      const glm::dvec3 normal = glm::cross(lamp.along, lamp.up);
      lamp.area = 0.5 * glm::length(normal);
      if (!(lamp.area > 0.0) || !std::isfinite(lamp.area)) continue;
      lamp.normal = normal / (2.0 * lamp.area);
      lamp.both = object.material.doubleSided;
      lampOf_[o][t] = static_cast<int>(lamps_.size());
      lamps_.push_back(lamp);
      power.push_back(shines * lamp.area * (lamp.both ? 2.0 : 1.0));
    }
  }
  byPower_ = DiscreteDistribution(power);
  for (const Light& light : scene.lights) {
    Source source;
    source.light = light;
    source.position = light.position - all.anchorWorld;
    source.direction = glm::length(light.direction) > 0.0 ? glm::normalize(light.direction) : glm::dvec3(0, -1, 0);
    source.power = glm::dvec3(light.color) * static_cast<double>(light.intensity);
    if (brightness(source.power) <= 0.0) continue;
    source.cosine = std::cos(0.5 * glm::radians(light.angleDegrees));
    source.sized = light.type == LightType::Directional ? light.angleDegrees > 1e-3 : light.radius > 0.0;
    sources_.push_back(source);
  }
  // Roughly by the flux that each sends into the scene, with a minimum share that limits noise.
  const double size = std::max(all.radius, 1e-12), disc = kPathPi * size * size;
  std::vector<double> kinds = {byPower_.empty() ? 0.0 : kPathPi * byPower_.whole(), sky_.mean() * kPathPi * disc};
  for (const Source& source : sources_) {
    const double flux = brightness(source.power);
    kinds.push_back(source.light.type == LightType::Directional ? flux * disc : flux * 4.0 * kPathPi);
  }
  double most = 0.0;
  for (const double kind : kinds) most = std::max(most, kind);
  for (double& kind : kinds) {
    if (kind > 0.0) kind = std::max(kind, 0.25 * most);
  }
  kinds_ = DiscreteDistribution(kinds);
}

std::optional<PathLights::Aim> PathLights::aimLamp(const glm::dvec3& from, double which, const glm::dvec2& u) const {
  const std::size_t index = byPower_.at(which);
  const Lamp& lamp = lamps_[index];
  const double root = std::sqrt(u.x);
  const glm::dvec2 barycentric(root * (1.0 - u.y), root * u.y);
  const glm::dvec3 to = lamp.corner + barycentric.x * lamp.along + barycentric.y * lamp.up - from;
  const double distance = glm::length(to);
  if (!(distance > 0.0)) return std::nullopt;
  Aim aim;
  aim.direction = to / distance;
  aim.distance = distance;
  aim.object = lamp.object;
  const double cosine = -glm::dot(lamp.normal, aim.direction);
  if (cosine <= 0.0 && !lamp.both) return std::nullopt;
  PathHit hit;
  hit.object = lamp.object;
  hit.triangle = lamp.triangle;
  hit.barycentric = barycentric;
  hit.normal = cosine >= 0.0 ? lamp.normal : -lamp.normal;
  hit.back = cosine < 0.0;
  aim.density = byPower_.share(index) / lamp.area * distance * distance / std::max(std::abs(cosine), 1e-12);
  aim.radiance = scene_.surface(hit, aim.direction).emission / aim.density;
  return aim;
}

double PathLights::falloff(const Source& source, const glm::dvec3& toLight, double distance) {
  double factor = 1.0;
  if (source.light.range > 0.0) {
    // KHR_lights_punctual, "Range Property".
    const double share = distance / source.light.range, share2 = share * share;
    factor = std::clamp(1.0 - share2 * share2, 0.0, 1.0);
  }
  if (source.light.type == LightType::Spot) {
    // The same, "Inner and Outer Cone Angles".
    const double inner = std::cos(glm::radians(source.light.innerConeDegrees));
    const double outer = std::cos(glm::radians(source.light.outerConeDegrees));
    const double within =
        std::clamp((-glm::dot(toLight, source.direction) - outer) / std::max(inner - outer, 0.001), 0.0, 1.0);
    factor *= within * within;
  }
  return factor;
}

std::optional<PathLights::Aim> PathLights::aimSource(const glm::dvec3& from, std::size_t index,
                                                     const glm::dvec2& u) const {
  const Source& source = sources_[index];
  Aim aim;
  if (source.light.type == LightType::Directional) {
    aim.distance = kPathInfinity;
    aim.direction = source.sized ? inCone(-source.direction, source.cosine, u) : -source.direction;
    aim.radiance = source.power;  // the disc's radiance over its density is its irradiance
    if (source.sized) {
      const double angle = 2.0 * kPathPi * (1.0 - source.cosine);
      aim.density = 1.0 / angle;
      // The light gives its irradiance at normal incidence: divide by the mean cosine over the disc.
      aim.radiance = source.power / (0.5 * (1.0 + source.cosine));
    }
    return aim;
  }
  const glm::dvec3 to = source.position - from;
  const double distance = glm::length(to);
  if (!(distance > 0.0)) return std::nullopt;
  const double factor = falloff(source, to / distance, distance);
  if (factor <= 0.0) return std::nullopt;
  if (!source.sized || distance <= source.light.radius) {
    // Inside the sphere no side of it is visible: treated as a point.
    aim.direction = to / distance;
    aim.distance = distance;
    aim.radiance = source.power * factor / std::max(distance * distance, 1e-12);
    return aim;
  }
  const double height = coneHeight(source.light.radius, distance);
  aim.direction = inCone(to / distance, 1.0 - height, u);
  const double along = glm::dot(to, aim.direction), radius2 = source.light.radius * source.light.radius;
  aim.distance = along - std::sqrt(std::max(radius2 - (distance * distance - along * along), 0.0));
  aim.density = 1.0 / (2.0 * kPathPi * height);
  aim.radiance = source.power * factor / (kPathPi * radius2) / aim.density;
  return aim;
}

std::optional<PathLights::Aim> PathLights::aim(const glm::dvec3& from, double which, const glm::dvec2& u) const {
  if (kinds_.empty()) return std::nullopt;
  const std::size_t kind = kinds_.at(which);
  const double chance = kinds_.share(kind);
  std::optional<Aim> aim;
  if (kind == 0) {
    aim = aimLamp(from, which, u);
  } else if (kind == 1) {
    aim.emplace();
    aim->distance = kPathInfinity;
    aim->direction = sky_.sample(u, aim->density);
    aim->radiance = sky_.radiance(aim->direction) / aim->density;
  } else {
    aim = aimSource(from, kind - 2, u);
    if (aim) aim->source = true;
  }
  if (!aim) return std::nullopt;
  aim->radiance /= chance;
  aim->density *= chance;
  return aim;
}

double PathLights::lampDensity(const PathHit& hit, const glm::dvec3& direction) const {
  const auto& ofObject = lampOf_[static_cast<std::size_t>(hit.object)];
  const int index = hit.triangle < ofObject.size() ? ofObject[hit.triangle] : -1;
  if (index < 0 || kinds_.empty()) return 0.0;
  const Lamp& lamp = lamps_[static_cast<std::size_t>(index)];
  const double cosine = std::max(std::abs(glm::dot(hit.normal, direction)), 1e-12);
  return kinds_.share(0) * byPower_.share(static_cast<std::size_t>(index)) / lamp.area * hit.distance * hit.distance /
         cosine;
}

double PathLights::skyDensity(const glm::dvec3& direction) const {
  return kinds_.empty() || sky_.black() ? 0.0 : kinds_.share(1) * sky_.density(direction);
}

void PathLights::meet(const glm::dvec3& from, const glm::dvec3& direction, double distance,
                      std::vector<Met>& met) const {
  met.clear();
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    if (!source.sized) continue;
    Met one;
    if (source.light.type == LightType::Directional) {
      if (std::isfinite(distance) || -glm::dot(direction, source.direction) < source.cosine) continue;
      const double angle = 2.0 * kPathPi * (1.0 - source.cosine);
      one.density = 1.0 / angle;
      one.radiance = source.power / (0.5 * (1.0 + source.cosine)) / angle;
    } else {
      const glm::dvec3 to = source.position - from;
      const double away = glm::length(to), radius = source.light.radius;
      if (away <= radius) continue;
      const double along = glm::dot(to, direction), off2 = away * away - along * along;
      if (along <= 0.0 || off2 >= radius * radius) continue;
      if (along - std::sqrt(radius * radius - off2) >= distance) continue;
      const double factor = falloff(source, to / away, away);
      if (factor <= 0.0) continue;
      one.density = 1.0 / (2.0 * kPathPi * coneHeight(radius, away));
      one.radiance = source.power * factor / (kPathPi * radius * radius);
    }
    one.density *= kinds_.share(2 + i);
    met.push_back(one);
  }
}

}  // namespace boxprobe
