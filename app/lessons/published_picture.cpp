// See published_picture.h. The forms are those of shaders/published, which say where each is from, and more:
//   behind      a box's planes selected with step(0, R) into mix(max, min): those behind the ray
//   difference  as "world", but for (P - C) + d R: the subtraction first. Unity and Catlike Coding have it so
//   means       the cubemap's levels as plain means of four texels each, as glGenerateMipmap makes them
//   alone       each face of the cubemap looked up for itself, as hardware did before seamless lookups
//   fixup       the same with CubeMapGen's edge fix-up over four texels
//   masking     not a lookup: the split sum made with the masking that is most often printed
//   eta         glass, bent once by refract(-V, N, n2 / n1): Arm, "Guide to Unity: Enhancing Your Mobile Games", 6.4.4
#include "app/lessons/published_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/lessons/other_maps.h"
#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/lesson.h"
#include "filters/math/published/published_math.h"
#include "filters/math/shared/display_math.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 behind(const ProbeExplanation& probe) {
  float distance = 3.0e38f;
  for (int axis = 0; axis < 3; ++axis) {
    const float wall = probe.reflectionProbe[axis] > 0.0f ? probe.boxMin[axis] : probe.boxMax[axis];
    distance = std::min(distance, (wall - probe.positionProbe[axis]) / probe.reflectionProbe[axis]);
  }
  return probe.positionProbe + distance * probe.reflectionProbe;
}

shading::ProbeShape shapeOf(const ProbeExplanation& probe) {
  shading::ProbeShape shape{};
  shape.boxMin = probe.boxMin;
  shape.boxMax = probe.boxMax;
  shape.bevel = probe.bevel;
  return shape;
}

/// GLSL's refract(-V, N, eta): zero where it finds none.
glm::vec3 refracted(const Explanation& e, float eta) {
  const float cosine = glm::dot(e.surface.normalWorld, e.surface.viewWorld);
  const float k = 1.0f - eta * eta * (1.0f - cosine * cosine);
  if (k < 0.0f) return glm::vec3(0.0f);
  return (eta * cosine - std::sqrt(k)) * e.surface.normalWorld - eta * e.surface.viewWorld;
}

/// What a ray that goes on through glass looks up; not a number where there is no such ray.
glm::vec3 lookupThrough(const ProbeExplanation& probe, const glm::vec3& directionWorld) {
  const glm::vec3 direction = glm::transpose(glm::mat3(probe.worldFromProbe)) * directionWorld;
  return shading::publishedBoxMax(shapeOf(probe), probe.positionProbe, direction).direction;
}

/// The front of a glass, where `form` draws glass.
const GlassExplanation* glassBy(const std::string& form, const Explanation& e) {
  return form == "eta" && e.glass && !e.glass->back ? &*e.glass : nullptr;
}

/// Another map, or another lookup in the same, in the same direction.
bool keepsDirection(const std::string& form) {
  return form == "means" || form == "alone" || form == "fixup";
}

/// What the program itself looks up where `form` does.
glm::vec3 ownLookup(const std::string& form, const Explanation& e, const ProbeExplanation& probe) {
  const GlassExplanation* glass = glassBy(form, e);
  return glass != nullptr ? lookupThrough(probe, glass->directionWorld) : probe.lookupDirection;
}

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

glm::vec3 lookupBy(const std::string& form, const Explanation& e, const ProbeExplanation& probe) {
  if (form == "eta") return lookupThrough(probe, refracted(e, 1.0f / e.glass->eta));
  shading::ProbeShape shape = shapeOf(probe);
  if (keepsDirection(form)) return probe.lookupDirection;
  if (form == "behind") return behind(probe);
  if (form == "select") return shading::publishedBoxSelect(shape, probe.positionProbe, probe.reflectionProbe).direction;
  if (form == "rounded")
    return shading::publishedRoundedBox(shape, probe.positionProbe, probe.reflectionProbe).direction;
  // The rest has everything in single precision from the world's origin. Boxes that are not turned only.
  const glm::vec3 origin(probe.originWorld), position(e.surface.positionWorld), ray = probe.reflectionProbe;
  if (form == "half") return shading::publishedBoxHalf(shape, origin, position, ray).direction;
  shape.boxMin += origin;
  shape.boxMax += origin;
  if (form == "difference") return (position - origin) + shading::publishedBoxMax(shape, position, ray).distance * ray;
  return shading::publishedBoxWorld(shape, origin, position, ray).direction;
}

// What the reflection would be times, were the split sum made with the printed masking.
glm::vec3 byPublishedMasking(const Explanation& e) {
  const glm::vec2 printed = shading::publishedSplitSum(e.nDotV, e.surface.roughness);
  const glm::vec3 ours = e.f0 * e.brdf.x + e.brdf.y;
  return (e.f0 * printed.x + printed.y) / glm::max(ours, glm::vec3(1.0e-6f));
}

}  // namespace

bool isPublishedForm(const std::string& id) {
  const auto& forms = publishedForms();
  return std::find(forms.begin(), forms.end(), id) != forms.end();
}

PublishedPicture::PublishedPicture(SceneRenderer& renderer, const Scene& scene, std::string form, int width, int height)
    : renderer_(renderer), scene_(scene), form_(std::move(form)) {
  picture_.width = width;
  picture_.height = height;
  picture_.pixels.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
}

glm::vec3 PublishedPicture::lookedUp(const BakedMaps& maps, const glm::vec3& along, float level) {
  if (!keepsDirection(form_)) return glm::vec3(maps.radiance.fetch(along, level));
  if (form_ == "alone") return glm::vec3(fetchWithinFace(maps.radiance, along, level));
  const auto found = made_.find(&maps);
  constexpr int kFixupWidth = 4;  // CubeMapGen's
  const CubeMap& cube = found != made_.end()
                            ? found->second
                            : made_
                                  .emplace(&maps, form_ == "means" ? withPlainMeans(maps.radiance)
                                                                   : withEdgeFixup(maps.radiance, kFixupWidth))
                                  .first->second;
  return glm::vec3(form_ == "means" ? cube.fetch(along, level) : fetchWithinFace(cube, along, level));
}

bool PublishedPicture::draw(int rows) {
  const int end = std::min(next_ + rows, picture_.height);
  std::vector<glm::ivec2> places;
  for (int y = next_; y < end; ++y) {
    for (int x = 0; x < picture_.width; ++x) places.emplace_back(x, y);
  }
  if (places.empty()) return false;
  const auto explanations = renderer_.explain(places, picture_.width, picture_.height);
  for (std::size_t i = 0; i < explanations.size(); ++i) {
    const Explanation& e = explanations[i];
    glm::vec3 color = e.rendered.value_or(e.color);
    if (form_ == "masking" && e.hit) color += e.specular * (byPublishedMasking(e) - 1.0f);
    const GlassExplanation* glass = glassBy(form_, e);
    const bool looksUp = e.hit && e.dominant >= 0 && form_ != "masking" && (form_ != "eta" || glass != nullptr);
    const ProbeExplanation* probe = looksUp ? &e.probes[static_cast<std::size_t>(e.dominant)] : nullptr;
    const auto maps = probe != nullptr && !probe->lookups.empty() ? renderer_.mapsOnCpu(probe->name) : nullptr;
    if (maps) {
      ++reflecting_;
      const glm::vec3 direction = lookupBy(form_, e, *probe);
      if (finite(direction) && glm::dot(direction, direction) > 0.0f) {
        const glm::vec3 along = glm::mat3(probe->mapFromProbe) * direction;
        const float level = glass != nullptr ? shading::levelForRoughness(glass->roughness, probe->maxLevel)
                                             : probe->lookups.front().level;
        const glm::vec3 light = lookedUp(*maps, along, level);
        const float share = probe->weight * probe->intensity;
        color += glass != nullptr ? glass->passed * (share * light - glass->looked)
                                  : e.specularFactor * share * (light - probe->specular);
        turned_ += degreesBetween(direction, ownLookup(form_, e, *probe));
      } else {
        ++broken_;
        color = glm::vec3(1.0f, 0.0f, 1.0f) / static_cast<float>(scene_.exposure);
      }
    }
    float* pixel =
        &picture_.pixels[4 * (static_cast<std::size_t>(next_) * static_cast<std::size_t>(picture_.width) + i)];
    for (int c = 0; c < 3; ++c) pixel[c] = std::max(color[c], 0.0f);
    pixel[3] = 1.0f;
  }
  next_ = end;
  return next_ < picture_.height;
}

ImageRgba8 PublishedPicture::display(int scale) const {
  ImageRgba8 image;
  image.width = picture_.width * scale;
  image.height = picture_.height * scale;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y / scale) * static_cast<std::size_t>(picture_.width) +
                             static_cast<std::size_t>(x / scale);
      const float* p = &picture_.pixels[4 * at];
      for (const std::uint8_t byte : displayBytes({p[0], p[1], p[2]}, scene_.exposure, scene_.tone))
        image.pixels.push_back(byte);
      image.pixels.push_back(255);
    }
  }
  return image;
}

double PublishedPicture::brokenShare() const {
  return reflecting_ > 0 ? static_cast<double>(broken_) / static_cast<double>(reflecting_) : 0.0;
}

double PublishedPicture::meanTurn() const {
  const long long looked = reflecting_ - broken_;
  return looked > 0 ? turned_ / static_cast<double>(looked) : 0.0;
}

}  // namespace boxprobe
