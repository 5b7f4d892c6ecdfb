#include "filters/reference/path/reference_path.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>

#include "filters/reference/path/path_light.h"
#include "filters/reference/path/path_lobes.h"
#include "filters/reference/path/path_random.h"
#include "filters/reference/path/path_surface.h"
#include "filters/reference/trace/picture_rays.h"

namespace boxprobe {

namespace {

constexpr int kMostScatterings = 1000;  // limit for paths that do not end
constexpr int kMostStraight = 64;       // limit of blended surfaces that a ray passes in a row
constexpr int kCertainScatterings = 4;  // before Russian roulette

/// Veach's power heuristic.
double weighed(double own, double other) {
  return own * own / std::max(own * own + other * other, 1e-300);
}

/// A surface in the place of another that scatters all light by Lambert's law.
PathSurface whiteMatte(const PathSurface& surface) {
  PathSurface matte;
  matte.normal = matte.coatNormal = surface.normal;
  matte.tangent = surface.tangent;
  matte.color = glm::dvec3(1.0);
  matte.f0 = matte.specularEdge = 0.0;
  return matte;
}

std::uint32_t hashedSeed(std::uint64_t seed) {
  return PathRandom::hashed(static_cast<std::uint32_t>(seed) ^
                            PathRandom::hashed(static_cast<std::uint32_t>(seed >> 32)));
}

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

struct ReferencePath::Parts {
  Parts(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
        std::shared_ptr<const ImageRgbaF> skyImage)
      : triangles(makeTriangleScene(scene, models)), lights(scene, triangles, std::move(skyImage)) {}

  glm::dvec3 radiance(glm::dvec3 origin, glm::dvec3 direction, int bounces, PathQuantity quantity,
                      PathRandom& random) const;
  glm::dvec3 aimed(const PathHit& hit, const PathLobes& lobes, bool fromSources, PathRandom& random) const;

  PathScene triangles;
  PathLights lights;
};

/// Light of one emitter reflected towards the view. `fromSources`: including light sources of the scene.
glm::dvec3 ReferencePath::Parts::aimed(const PathHit& hit, const PathLobes& lobes, bool fromSources,
                                       PathRandom& random) const {
  const double which = random.one();
  const auto aim = lights.aim(hit.position, which, random.pair());
  if (!aim || !lobes.scatters() || (aim->source && !fromSources)) return glm::dvec3(0.0);
  const glm::dvec3 value = lobes.value(aim->direction);
  if (largestOf(value) <= 0.0 || largestOf(aim->radiance) <= 0.0) return glm::dvec3(0.0);
  const double weight = aim->density > 0.0 ? weighed(aim->density, lobes.density(aim->direction)) : 1.0;
  const double share = triangles.passes(hit, aim->direction, aim->distance, aim->object);
  return share * weight * value * aim->radiance;
}

glm::dvec3 ReferencePath::Parts::radiance(glm::dvec3 origin, glm::dvec3 direction, int bounces, PathQuantity quantity,
                                          PathRandom& random) const {
  const bool diffuse = quantity == PathQuantity::DiffuseLight;
  glm::dvec3 sum(0.0), through(1.0);
  double density = 0.0;  // of the direction, if light sources could be sampled in it
  int straight = 0;
  std::vector<PathLights::Met> met;
  for (int scattered = 0; scattered < kMostScatterings;) {
    const bool eye = scattered == 0;
    const auto hit = triangles.first(origin, direction, eye);
    if (!eye && !(diffuse && scattered == 1)) {
      lights.meet(origin, direction, hit ? hit->distance : kPathInfinity, met);
      for (const PathLights::Met& one : met) {
        sum += through * one.radiance * (density > 0.0 ? weighed(density, one.density) : 1.0);
      }
    }
    if (!hit) {
      if (diffuse && eye) return sum;
      const glm::dvec3 sky = lights.sky().radiance(direction);
      return sum + through * sky * (density > 0.0 ? weighed(density, lights.skyDensity(direction)) : 1.0);
    }
    PathSurface surface = triangles.surface(*hit, direction);
    if (diffuse && eye) surface = whiteMatte(surface);
    if (surface.opacity < 1.0 && random.one() >= surface.opacity) {
      if (++straight > kMostStraight) return sum;
      origin = triangles.away(*hit, direction);
      continue;
    }
    straight = 0;
    for (int c = 0; c < 3; ++c) {
      if (surface.absorption[c] > 0.0) through[c] *= std::exp(-surface.absorption[c] * std::max(hit->distance, 0.0));
    }
    if (largestOf(surface.emission) > 0.0) {
      const double other = lights.lampDensity(*hit, direction);
      sum += through * surface.emission * (density > 0.0 && other > 0.0 ? weighed(density, other) : 1.0);
    }
    if (scattered > bounces) return sum;
    const PathLobes lobes(surface, -direction);
    sum += through * aimed(*hit, lobes, !diffuse || !eye, random);
    const double which = random.one();
    const auto sample = lobes.sample(which, random.pair());
    if (!sample || !finite(sample->weight)) return sum;
    through *= sample->weight;
    if (++scattered >= kCertainScatterings) {
      const double stays = std::min(largestOf(through), 0.97);
      if (random.one() >= stays) return sum;
      through /= stays;
    }
    density = sample->density;
    direction = sample->direction;
    origin = triangles.away(*hit, direction);
  }
  return sum;
}

ReferencePath::ReferencePath(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                             std::shared_ptr<const ImageRgbaF> skyImage)
    : parts_(std::make_unique<const Parts>(scene, models, std::move(skyImage))) {}

ReferencePath::~ReferencePath() = default;

ReferencePicture ReferencePath::render(const Camera& camera, const PathSettings& settings,
                                       const ReferenceProgress& progress) const {
  const Parts& parts = *parts_;
  const PictureRays rays(camera, settings.width, settings.height);
  const RayPlan plan = planRays(settings.raysPerPixel, 1);
  const int bounces = settings.bounces.value_or(kMostScatterings);
  const glm::dvec3 anchor = parts.triangles.scene().anchorWorld;
  ProgressivePicture picture(settings.width, settings.height);
  const std::uint32_t seed = hashedSeed(settings.seed);
  picture.run(
      settings.part.within(settings.width, settings.height), plan.passes,
      [&](int x, int y, int pass) {
        ProgressivePicture::Pixel pixel;
        // Each pass has its own sequence, so that the spread gives the error of the mean.
        const std::uint32_t place =
            PathRandom::hashed(static_cast<std::uint32_t>(x) + 0x10001u * static_cast<std::uint32_t>(y));
        const std::uint32_t pixelSeed =
            PathRandom::hashed(seed + place + 0x85ebca6bu * static_cast<std::uint32_t>(pass));
        for (int i = 0; i < plan.raysPerPass; ++i) {
          PathRandom random(pixelSeed, static_cast<std::uint32_t>(i));
          const glm::dvec2 anywhere = random.pair();
          const glm::dvec2 within = settings.quantity == PathQuantity::Radiance ? anywhere : glm::dvec2(0.5);
          const glm::dvec3 direction = glm::normalize(rays.direction(x + within.x, y + within.y));
          const glm::dvec3 light = parts.radiance(rays.origin(x + within.x, y + within.y) - anchor, direction, bounces,
                                                  settings.quantity, random);
          if (finite(light)) pixel.color += light / static_cast<double>(plan.raysPerPass);
        }
        const glm::dvec3 middle = glm::normalize(rays.direction(x + 0.5, y + 0.5));
        pixel.alpha = parts.triangles.first(rays.origin(x + 0.5, y + 0.5) - anchor, middle, true) ? 1.0 : 0.0;
        return pixel;
      },
      progress);
  return picture.picture();
}

std::vector<glm::dvec3> ReferencePath::radianceAlong(const std::vector<PathRay>& rays, int paths, std::uint64_t seed,
                                                     const ReferenceProgress& progress) const {
  const glm::dvec3 anchor = parts_->triangles.scene().anchorWorld;
  const std::uint32_t hashed = hashedSeed(seed);
  constexpr std::size_t kAtOnce = 4096;  // between two reports
  std::vector<glm::dvec3> light(rays.size(), glm::dvec3(0.0));
  for (std::size_t begin = 0; begin < rays.size(); begin += kAtOnce) {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(rays.size()))) return {};
    tbb::parallel_for(begin, std::min(begin + kAtOnce, rays.size()), [&](std::size_t i) {
      const std::uint32_t raySeed = PathRandom::hashed(hashed + rays[i].stream);
      for (int path = 0; path < paths; ++path) {
        PathRandom random(raySeed, static_cast<std::uint32_t>(path));
        const glm::dvec3 one =
            parts_->radiance(rays[i].from - anchor, rays[i].along, kMostScatterings, PathQuantity::Radiance, random);
        if (finite(one)) light[i] += one / static_cast<double>(paths);
      }
    });
  }
  return light;
}

ImageRgbaF diffuseTruthImage(const ReferencePicture& light) {
  ImageRgbaF image = light.color;
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    float squares = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      squares += light.standardError.pixels[i + c] * light.standardError.pixels[i + c];
    }
    image.pixels[i + 3] = light.color.pixels[i + 3] > 0.0f ? squares : -1.0f;
  }
  return image;
}

std::vector<std::string> ReferencePath::remarks() const {
  std::vector<std::string> lines;
  if (parts_->lights.dark()) lines.emplace_back("nothing in the scene sends light: the picture is black");
  bool film = false, occluded = false;
  for (const TracedObject& object : parts_->triangles.scene().objects) {
    film = film || (object.material.finish.hasFilm() && object.material.transmits() && !object.material.thin);
    occluded = occluded || object.material.occlusionTexture.image != nullptr;
  }
  if (film) lines.emplace_back("thin films on solid glass are not traced");
  if (occluded) lines.emplace_back("occlusion textures are not used: what they stand for is traced");
  return lines;
}

}  // namespace boxprobe
