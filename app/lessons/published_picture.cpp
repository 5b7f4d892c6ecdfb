// See published_picture.h. The forms are those of shaders/published, which say where each is from, and one more:
//   behind   a box's planes selected with step(0, R) into mix(max, min): those behind the ray
//   masking  not a lookup: the split sum made with the masking that is most often printed
#include "app/lessons/published_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "filters/math/published/published_math.h"
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

glm::vec3 lookupBy(const std::string& form, const Explanation& e, const ProbeExplanation& probe) {
  shading::ProbeShape shape{};
  shape.boxMin = probe.boxMin;
  shape.boxMax = probe.boxMax;
  shape.bevel = probe.bevel;
  if (form == "behind") return behind(probe);
  if (form == "select") return shading::publishedBoxSelect(shape, probe.positionProbe, probe.reflectionProbe).direction;
  if (form == "rounded")
    return shading::publishedRoundedBox(shape, probe.positionProbe, probe.reflectionProbe).direction;
  // "world": everything in single precision from the world's origin. Boxes that are not turned only.
  const glm::vec3 origin(probe.originWorld);
  shape.boxMin += origin;
  shape.boxMax += origin;
  return shading::publishedBoxWorld(shape, origin, glm::vec3(e.surface.positionWorld), probe.reflectionProbe).direction;
}

// What the reflection would be times, were the split sum made with the printed masking.
glm::vec3 byPublishedMasking(const Explanation& e) {
  const glm::vec2 printed = shading::publishedSplitSum(e.nDotV, e.surface.roughness);
  const glm::vec3 ours = e.f0 * e.brdf.x + e.brdf.y;
  return (e.f0 * printed.x + printed.y) / glm::max(ours, glm::vec3(1.0e-6f));
}

}  // namespace

bool isPublishedForm(const std::string& id) {
  return id == "behind" || id == "select" || id == "world" || id == "rounded" || id == "masking";
}

PublishedPicture::PublishedPicture(SceneRenderer& renderer, const Scene& scene, std::string form, int width, int height)
    : renderer_(renderer), scene_(scene), form_(std::move(form)) {
  picture_.width = width;
  picture_.height = height;
  picture_.pixels.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
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
    const ProbeExplanation* probe =
        e.hit && e.dominant >= 0 && form_ != "masking" ? &e.probes[static_cast<std::size_t>(e.dominant)] : nullptr;
    const auto maps = probe != nullptr && !probe->lookups.empty() ? renderer_.mapsOnCpu(probe->name) : nullptr;
    if (maps) {
      ++reflecting_;
      const glm::vec3 direction = lookupBy(form_, e, *probe);
      if (finite(direction) && glm::dot(direction, direction) > 0.0f) {
        const glm::vec3 along = glm::mat3(probe->mapFromProbe) * direction;
        const glm::vec3 light(maps->radiance.fetch(along, probe->lookups.front().level));
        color += e.specularFactor * probe->weight * probe->intensity * (light - probe->specular);
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
      for (std::size_t c = 0; c < 3; ++c) {
        const double shown = std::clamp(scene_.exposure * static_cast<double>(picture_.pixels[4 * at + c]), 0.0, 1.0);
        image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::pow(shown, 1.0 / 2.2))));
      }
      image.pixels.push_back(255);
    }
  }
  return image;
}

double PublishedPicture::brokenShare() const {
  return reflecting_ > 0 ? static_cast<double>(broken_) / static_cast<double>(reflecting_) : 0.0;
}

}  // namespace boxprobe
