#include "filters/reference/trace/refraction_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

namespace {

constexpr double kLeast = 1.0e-3;  // of the pixel: branches that carry less are not followed
constexpr int kDeepest = 24;

// Fresnel's reflectance with Snell's law, n1 on the ray's side; `far`: the cosine behind the interface, 0 for total
// reflection.
double reflectance(double cosine, double n1, double n2, double& far) {
  const double sine = n1 / n2 * std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  far = 0.0;
  if (sine >= 1.0) return 1.0;
  far = std::sqrt(1.0 - sine * sine);
  const double s = (n1 * cosine - n2 * far) / (n1 * cosine + n2 * far);
  const double p = (n1 * far - n2 * cosine) / (n1 * far + n2 * cosine);
  return 0.5 * (s * s + p * p);
}

glm::dvec3 bent(const glm::dvec3& direction, const glm::dvec3& facing, double ratio, double cosine, double far) {
  return glm::normalize(ratio * direction + (ratio * cosine - far) * facing);
}

// Transmittance by Beer's law.
glm::dvec3 transmittance(const Material& m, double distance) {
  glm::dvec3 left(1.0);
  if (m.attenuationDistance <= 0.0f) return left;
  const double lengths = distance / static_cast<double>(m.attenuationDistance);
  for (int i = 0; i < 3; ++i) left[i] = std::pow(static_cast<double>(m.attenuationColor[i]), lengths);
  return left;
}

}  // namespace

bool smoothGlass(double roughness) {
  return roughness * roughness < 1.0e-6;
}

/// The random numbers of a path.
struct RefractionTracer::Path {
  std::uint64_t state = 0;
  bool rough = false;  ///< it has met a rough surface: from there on it is a single ray, not a tree
  double next() {
    state = hashBits(state + 1);
    return static_cast<double>(state >> 11) * 0x1p-53;
  }
};

glm::dvec3 RefractionTracer::seen(const TracedHit& hit, const glm::dvec3& direction, int rays,
                                  std::uint64_t seed) const {
  const bool smooth = smoothGlass(static_cast<double>(tracer_.object(hit).material.roughness));
  const int count = smooth ? 1 : std::max(rays, 1);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i) {
    Path path;
    path.state = hashBits(seed + static_cast<std::uint64_t>(i));
    sum += meet(hit, direction, 1.0, 0, path);
  }
  const Material& m = tracer_.object(hit).material;
  // The eye is inside the glass.
  const glm::dvec3 left = hit.backSide && !m.thin ? transmittance(m, hit.distance) : glm::dvec3(1.0);
  return left * sum / static_cast<double>(count);
}

glm::dvec3 RefractionTracer::meet(const TracedHit& hit, const glm::dvec3& direction, double weight, int depth,
                                  Path& path) const {
  const TracedObject& object = tracer_.object(hit);
  const Material& m = object.material;
  const SurfacePoint surface = tracer_.surface(hit, hit.positionWorld - direction);
  const glm::dvec3 near = tracer_.awayFrom(hit), far = 2.0 * hit.positionWorld - near;
  glm::dvec3 normal = glm::normalize(glm::dvec3(surface.normalWorld));
  if (glm::dot(normal, direction) >= -1.0e-6) normal = hit.frontWorld;
  const double ior = static_cast<double>(m.ior);
  const bool within = hit.backSide && !m.thin;
  const double n1 = within ? ior : 1.0, n2 = within ? 1.0 : ior;
  const bool smooth = smoothGlass(static_cast<double>(surface.roughness));
  path.rough = path.rough || !smooth;
  const double alpha = static_cast<double>(surface.roughness) * static_cast<double>(surface.roughness);
  const glm::dvec3 tint = depth == 0 ? glm::dvec3(surface.albedo) : glm::dvec3(1.0);

  // Draws a half vector of the surface as the ray sees it.
  const auto facet = [&](const glm::dvec3& n, const glm::dvec3& view) {
    if (smooth) return n;
    const VisibleNormalLobe lobe(n, view, alpha);
    const double u = path.next(), v = path.next();
    const glm::dvec3 half = lobe.sample({u, v}).direction + view;
    const double length = glm::length(half);
    return length > 1.0e-9 ? half / length : n;
  };
  const auto mirrored = [&](double share) {
    for (int i = 0; i < 16; ++i) {
      const glm::dvec3 h = facet(normal, -direction);
      const glm::dvec3 away = direction - 2.0 * glm::dot(direction, h) * h;
      if (glm::dot(away, normal) <= 0.0 && !smooth) continue;
      return follow(near, away, within ? hit.object : -1, -1, share, depth + 1, path);
    }
    return glm::dvec3(0.0);
  };

  if (m.thin) {
    double inside = 0.0;
    const double one = reflectance(-glm::dot(direction, normal), 1.0, ior, inside);
    const double both = 2.0 * one / (1.0 + one);
    glm::dvec3 away = direction;
    if (!smooth) {
      // Enters through one facet, leaves through another.
      for (int i = 0; i < 16; ++i) {
        const glm::dvec3 h = facet(normal, -direction);
        const double c = -glm::dot(direction, h);
        double beyond = 0.0;
        if (c <= 0.0 || reflectance(c, 1.0, ior, beyond) >= 1.0) continue;
        const glm::dvec3 in = bent(direction, h, 1.0 / ior, c, beyond);
        if (glm::dot(in, normal) >= 0.0) continue;
        const glm::dvec3 g = facet(normal, -in);
        const double d = -glm::dot(in, g);
        if (d <= 0.0 || reflectance(d, ior, 1.0, beyond) >= 1.0) continue;
        away = bent(in, g, ior, d, beyond);
        if (glm::dot(away, normal) < 0.0) break;
        away = direction;
      }
    }
    if (path.rough) {
      if (path.next() < both) return mirrored(weight);
      return tint * follow(far, away, -1, hit.object, weight, depth + 1, path);
    }
    return both * mirrored(weight * both) +
           (1.0 - both) * tint * follow(far, away, -1, hit.object, weight * (1.0 - both), depth + 1, path);
  }

  double beyond = 0.0;
  if (path.rough) {
    for (int i = 0; i < 16; ++i) {
      const glm::dvec3 h = facet(normal, -direction);
      const double c = -glm::dot(direction, h);
      if (c <= 0.0) continue;
      const double f = reflectance(c, n1, n2, beyond);
      if (path.next() < f) {
        const glm::dvec3 away = direction + 2.0 * c * h;
        if (glm::dot(away, normal) <= 0.0) continue;
        return follow(near, away, within ? hit.object : -1, -1, weight, depth + 1, path);
      }
      const glm::dvec3 away = bent(direction, h, n1 / n2, c, beyond);
      if (glm::dot(away, normal) >= 0.0) continue;
      return tint * follow(far, away, within ? -1 : hit.object, -1, weight, depth + 1, path);
    }
    return glm::dvec3(0.0);
  }
  const double c = -glm::dot(direction, normal);
  const double f = reflectance(c, n1, n2, beyond);
  glm::dvec3 sum(0.0);
  if (f > 0.0) sum += f * mirrored(weight * f);
  if (f < 1.0) {
    sum += (1.0 - f) * tint *
           follow(far, bent(direction, normal, n1 / n2, c, beyond), within ? -1 : hit.object, -1, weight * (1.0 - f),
                  depth + 1, path);
  }
  return sum;
}

// `within`: the object whose glass the ray is in, or -1; `passed`: a sheet whose other faces are skipped.
glm::dvec3 RefractionTracer::follow(const glm::dvec3& origin, const glm::dvec3& direction, int within, int passed,
                                    double weight, int depth, Path& path) const {
  if (depth > kDeepest || weight < kLeast) return outside_(origin, direction);
  glm::dvec3 from = origin;
  for (int skipped = 0; skipped < 8; ++skipped) {
    const auto hit = tracer_.firstHit(from, direction, RaySees::Picture);
    if (!hit || !tracer_.object(*hit).material.transmits()) break;
    if (hit->object == passed || (within >= 0 && hit->object != within)) {
      from = 2.0 * hit->positionWorld - tracer_.awayFrom(*hit);
      continue;
    }
    if (within < 0) return meet(*hit, direction, weight, depth, path);
    const glm::dvec3 left = transmittance(tracer_.object(*hit).material, glm::length(hit->positionWorld - origin));
    return left * meet(*hit, direction, weight, depth, path);
  }
  return outside_(from, direction);
}

}  // namespace boxprobe
