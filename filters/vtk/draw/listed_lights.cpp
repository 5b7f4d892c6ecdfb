#include "filters/vtk/draw/listed_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

void ListedLights::set(const std::vector<Light>& lights, const glm::dvec3& center) {
  lights_.clear();
  texels_.clear();
  center_ = center;
  constexpr double kLargest = 1.0e30;  // as in scene_lights.cpp
  for (const Light& light : lights) {
    const bool positional = light.type != LightType::Directional, spot = light.type == LightType::Spot;
    lights_.push_back({light.position, positional && light.range > 0.0 ? light.range : -1.0});
    const double perRange = light.range > 0.0 ? std::min(1.0 / light.range, kLargest) : 0.0;
    const glm::dvec3 along =
        light.type == LightType::Point ? glm::dvec3(0.0, -1.0, 0.0) : glm::normalize(light.direction);
    texels_.emplace_back(glm::vec3(light.position - center), static_cast<float>(perRange));
    texels_.emplace_back(light.color * light.intensity, positional ? 1.0f : 0.0f);
    texels_.emplace_back(glm::vec3(along),
                         spot ? static_cast<float>(std::min(light.outerConeDegrees, 89.999)) : 180.0f);
    texels_.emplace_back(spot ? static_cast<float>(std::cos(glm::radians(light.innerConeDegrees))) : 1.0f, 0.0f, 0.0f,
                         0.0f);
  }
  startLists();
}

void ListedLights::startLists() {
  texels_.resize(kTexels * lights_.size());
  lists_.clear();
  uploaded_ = 0;
}

ListedLights::Reaching ListedLights::reaching(const double* boundsWorld) {
  std::array<double, 6> bounds{-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL};
  if (boundsWorld != nullptr) std::copy_n(boundsWorld, 6, bounds.begin());
  if (const auto known = lists_.find(bounds); known != lists_.end()) return known->second;
  // An object that is dragged leaves a list at each place.
  constexpr std::size_t kMostTexels = std::size_t(1) << 20;
  if (texels_.size() > kMostTexels + kTexels * lights_.size()) startLists();
  Reaching reached{static_cast<int>(texels_.size()), 0};
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const Sphere& light = lights_[i];
    if (light.radius >= 0.0) {
      const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
      const glm::dvec3 off = glm::clamp(light.center, low, high) - light.center;
      if (glm::dot(off, off) > light.radius * light.radius) continue;
    }
    if (reached.count % 4 == 0) texels_.emplace_back(0.0f);
    texels_.back()[reached.count % 4] = static_cast<float>(i);
    ++reached.count;
  }
  lists_.emplace(bounds, reached);
  return reached;
}

GLuint ListedLights::texture() {
  if (handle_ != 0 && uploaded_ == texels_.size()) return handle_;
  GLint previous = 0, alignment = 4;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &previous);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  if (handle_ == 0) glGenTextures(1, &handle_);
  glBindTexture(GL_TEXTURE_2D, handle_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const std::size_t rows = std::max<std::size_t>((texels_.size() + kWidth - 1) / kWidth, 1);
  const auto width = static_cast<GLsizei>(kWidth);
  if (rows > rows_) {
    rows_ = std::max(rows, 2 * rows_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, static_cast<GLsizei>(rows_), 0, GL_RGBA, GL_FLOAT, nullptr);
    uploaded_ = 0;
  }
  // Each object adds its list to the last rows: only those are uploaded.
  const std::size_t first = uploaded_ / kWidth;
  std::vector<glm::vec4> last(texels_.begin() + static_cast<std::ptrdiff_t>(first * kWidth), texels_.end());
  last.resize((rows - first) * kWidth);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(first), width, static_cast<GLsizei>(rows - first), GL_RGBA,
                  GL_FLOAT, last.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(previous));
  uploaded_ = texels_.size();
  return handle_;
}

void ListedLights::release() {
  if (handle_ != 0) glDeleteTextures(1, &handle_);
  handle_ = 0;
  uploaded_ = rows_ = 0;
}

}  // namespace boxprobe
