#include "filters/reference/light/reference_scene.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/reference/light/reflecting_layers.h"
#include "filters/reference/light/sheen_light.h"
#include "filters/reference/trace/picture_rays.h"
#include "filters/reference/trace/refraction_tracer.h"
#include "filters/reference/trace/shadow_light.h"
#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

namespace {

bool mirrorsOnly(const std::vector<ReflectingLayer>& layers, const SurfacePoint& s) {
  for (const ReflectingLayer& layer : layers) {
    if (!layer.lobe(glm::normalize(glm::dvec3(s.viewWorld))).mirror()) return false;
  }
  return true;
}

}  // namespace

int positionsPerSide(int samplesPerPixel) {
  return samplesPerPixel >= 16 ? 4 : samplesPerPixel >= 4 ? 2 : 1;
}

ReferenceScene::ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                               std::shared_ptr<const ImageRgbaF> skyImage)
    : tracer_(makeTriangleScene(scene, models)),
      lamps_(tracer_.scene()),
      light_(std::make_shared<CaptureLight>(scene, std::move(skyImage))),
      brightSky_(std::make_shared<BrightSky>(light_->sky().chain())) {}

ReferenceScene::ReferenceScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                               const ReferenceScene& sameLight)
    : tracer_(makeTriangleScene(scene, models)),
      lamps_(tracer_.scene()),
      light_(sameLight.light_),
      brightSky_(sameLight.brightSky_) {}

// Transmittance for each light; empty if no light casts shadows.
std::vector<glm::vec3> ReferenceScene::throughTo(const TracedHit& hit, RaySees sees, int side) const {
  std::vector<glm::vec3> through;
  const std::vector<Light>& lights = light_->lights();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i].shadows == LightShadows::None) continue;
    through.resize(lights.size(), glm::vec3(1.0f));
    through[i] = glm::vec3(lightThrough(tracer_, tracer_.awayFrom(hit), lights[i], side, sees));
  }
  return through;
}

glm::dvec3 ReferenceScene::seenFrom(const glm::dvec3& origin, const glm::dvec3& direction, RaySees sees) const {
  const auto hit = tracer_.firstHit(origin, direction, sees);
  return hit ? sent(*hit, origin, sees) : glm::dvec3(light_->sky().radiance(glm::vec3(direction)));
}

// The radiance of a hit towards the origin of its ray.
glm::dvec3 ReferenceScene::sent(const TracedHit& hit, const glm::dvec3& origin, RaySees sees) const {
  // Highlights and other gloss depend on the eye; a probe has them as seen from its origin.
  const glm::dvec3 eye = sees == RaySees::Probes ? light_->capturedFrom(origin).value_or(origin) : origin;
  // A reflection averages many rays: few shadow rays are enough.
  constexpr int kShadowSide = 2;
  const std::vector<glm::vec3> through = throughTo(hit, sees, kShadowSide);
  return glm::dvec3(light_->captured(tracer_.surface(hit, eye), tracer_.object(hit).material.unlit,
                                     through.empty() ? nullptr : &through));
}

glm::dvec3 ReferenceScene::reflectedFrom(const SurfacePoint& surface, const glm::dvec3& away, RaySees sees, int rays,
                                         std::uint64_t seed) const {
  glm::dvec3 sum(0.0);
  for (const ReflectingLayer& layer : reflectingLayers(surface, light_->energy())) {
    sum += reflected(layer, glm::normalize(glm::dvec3(surface.viewWorld)), away, sees, rays, seed);
    seed = hashBits(seed);
  }
  if (surface.finish && surface.finish->hasSheen()) {
    sum += static_cast<double>(surface.occlusion) * sheenReflected(surface, away, sees, rays, seed);
  }
  return sum;
}

// Cosine-weighted rays: the lobe is broad.
glm::dvec3 ReferenceScene::sheenReflected(const SurfacePoint& surface, const glm::dvec3& away, RaySees sees, int rays,
                                          std::uint64_t seed) const {
  constexpr double kPi = 3.14159265358979323846;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(surface.normalWorld));
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 t = glm::normalize(glm::cross(normal, axis)), b = glm::cross(normal, t);
  const ShiftedPoints points(seed);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < rays; ++i) {
    const glm::dvec2 u = points[i];
    const double radius = std::sqrt(u.x), z = std::sqrt(1.0 - u.x), turn = 2.0 * kPi * u.y;
    const glm::dvec3 l = radius * std::cos(turn) * t + radius * std::sin(turn) * b + z * normal;
    if (z > 1.0e-6) sum += sheenSent(surface, l) * (kPi / z) * seenFrom(away, l, sees);
  }
  return sum / static_cast<double>(rays);
}

// Half of the rays follow the lobe, and half go towards lamps and bright sky. Light that several strategies can sample
// is weighted by the balance heuristic (Veach and Guibas 1995).
glm::dvec3 ReferenceScene::reflected(const ReflectingLayer& layer, const glm::dvec3& view, const glm::dvec3& away,
                                     RaySees sees, int rays, std::uint64_t seed) const {
  const VisibleNormalLobe lobe = layer.lobe(view);
  const auto reflectance = [&](double hDotV) { return layer.reflectance(hDotV); };
  const int aims = (lamps_.empty() ? 0 : 1) + (brightSky_->empty() ? 0 : 1);
  if (aims == 0 || lobe.mirror() || rays < 2 * aims) {
    return lobeReflected(lobe, rays, seed, reflectance,
                         [&](const glm::dvec3& direction) { return seenFrom(away, direction, sees); });
  }
  const int each = rays / (2 * aims), byLobe = rays - aims * each;
  const int towardsLamps = lamps_.empty() ? 0 : each, towardsSky = brightSky_->empty() ? 0 : each;
  glm::dvec3 shining(0.0);
  const auto add = [&](const VisibleNormalLobe::Density& of, double aimed, const glm::dvec3& light) {
    const double density = byLobe * of.density + each * aimed;
    if (density > 0.0) shining += of.weight * of.density / density * layer.reflectance(of.hDotV) * light;
  };
  const auto addSky = [&](const glm::dvec3& direction, const VisibleNormalLobe::Density& of, const glm::dvec3& light) {
    add(of, brightSky_->density(direction), light);
  };
  const auto skyAt = [&](const glm::dvec3& direction) {
    return glm::dvec3(light_->sky().radiance(glm::vec3(direction)));
  };
  const glm::dvec3 rest = lobeReflected(lobe, byLobe, seed, reflectance, [&](const glm::dvec3& direction) {
    const auto hit = tracer_.firstHit(away, direction, sees);
    if (hit && !lamps_.shines(*hit)) return sent(*hit, away, sees);
    if (hit) {
      add(lobe.at(direction), lamps_.density(*hit), sent(*hit, away, sees));
      return glm::dvec3(0.0);
    }
    const glm::dvec3 all = skyAt(direction);
    if (towardsSky == 0) return all;
    const glm::dvec3 bright = brightSky_->excess(all);
    addSky(direction, lobe.at(direction), bright);
    return all - bright;
  });
  const ShiftedPoints lampPoints(hashBits(seed ^ 0x5bd1e995u));
  for (int i = 0; i < towardsLamps; ++i) {
    const LampTriangles::Towards lamp = lamps_.towards(away, lampPoints[i]);
    const VisibleNormalLobe::Density of = lobe.at(lamp.direction);
    if (!(of.weight > 0.0)) continue;
    const auto hit = tracer_.firstHit(away, lamp.direction, sees);
    if (hit && lamp.meets(*hit)) add(of, lamps_.density(*hit), sent(*hit, away, sees));
  }
  const ShiftedPoints skyPoints(hashBits(seed ^ 0x1b873593u));
  for (int i = 0; i < towardsSky; ++i) {
    const glm::dvec3 direction = brightSky_->towards(skyPoints[i]);
    const VisibleNormalLobe::Density of = lobe.at(direction);
    if (!(of.weight > 0.0) || tracer_.firstHit(away, direction, sees)) continue;
    addSky(direction, of, brightSky_->excess(skyAt(direction)));
  }
  return rest + shining;
}

ReferencePicture ReferenceScene::render(const Camera& camera, const ReferenceSettings& settings,
                                        const ReferenceProgress& progress) const {
  const PictureRays rays(camera, settings.width, settings.height);
  const int side = positionsPerSide(settings.samplesPerPixel);
  const RayPlan plan = planRays(settings.raysPerPixel, side * side);
  const RaySees sees = settings.full ? RaySees::Picture : RaySees::Probes;
  const RefractionTracer glass(tracer_, [&](const glm::dvec3& origin, const glm::dvec3& direction) {
    return seenFrom(origin, direction, sees);
  });
  const auto estimate = [&](int x, int y, int pass) {
    ProgressivePicture::Pixel pixel;
    pixel.exact = true;
    for (int k = 0; k < side * side; ++k) {
      const double across = x + (k % side + 0.5) / side, down = y + (k / side + 0.5) / side;
      const glm::dvec3 eye = rays.origin(across, down), direction = rays.direction(across, down);
      const auto hit = tracer_.firstHit(eye, direction);
      if (!hit) {
        pixel.color += glm::dvec3(light_->sky().radiance(glm::vec3(direction)));
        continue;
      }
      pixel.alpha += 1.0;
      const SurfacePoint surface = tracer_.surface(*hit, eye);
      const bool unlit = tracer_.object(*hit).material.unlit;
      const Material& material = tracer_.object(*hit).material;
      const double passes = material.transmits() ? static_cast<double>(material.transmission) *
                                                       (1.0 - static_cast<double>(surface.metallic))
                                                 : 0.0;
      constexpr int kShadowSide = 6;
      const std::vector<glm::vec3> through = throughTo(*hit, RaySees::Picture, kShadowSide);
      pixel.color +=
          (1.0 - passes) *
          glm::dvec3(light_->unreflected(surface, unlit, through.empty() ? nullptr : &through, settings.diffuse.get()));
      if (unlit) continue;
      const std::uint64_t place =
          (static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings.width) + static_cast<std::uint64_t>(x)) *
              16 +
          static_cast<std::uint64_t>(k);
      const std::uint64_t seed = hashBits(hashBits(hashBits(settings.seed) + place) + static_cast<std::uint64_t>(pass));
      if (passes > 0.0) {
        pixel.color += passes * (glm::dvec3(surface.emissive) +
                                 glass.seen(*hit, glm::normalize(direction), plan.raysPerPass, hashBits(seed)));
        pixel.exact = pixel.exact && smoothGlass(static_cast<double>(surface.roughness));
        if (passes == 1.0) continue;
      }
      pixel.color += (1.0 - passes) * reflectedFrom(surface, tracer_.awayFrom(*hit), sees, plan.raysPerPass, seed);
      pixel.exact = pixel.exact && mirrorsOnly(reflectingLayers(surface, light_->energy()), surface);
    }
    pixel.color /= side * side;
    pixel.alpha /= side * side;
    return pixel;
  };
  ProgressivePicture picture(settings.width, settings.height);
  picture.run(settings.part.within(settings.width, settings.height), plan.passes, estimate, progress);
  return picture.picture();
}

}  // namespace boxprobe
