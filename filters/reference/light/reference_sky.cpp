#include "filters/reference/light/reference_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe {

namespace {

// Face sizes as in filters/vtk/probes/probe_plan.cpp: a gradient has no detail.
constexpr int kFaceSize = 64;
constexpr int kImageFaceSize = 256;
// Samples along each side of a texel of a picture: must not miss a sun of a few pixels.
constexpr int kImageSamples = 4;
// More resolution than nine coefficients need.
constexpr int kIrradianceFaceSize = 16;

ShCoefficients coefficientsOf(const CubeMap& source) {
  int level = 0;
  while (source.levelSize(level) > kIrradianceFaceSize) ++level;
  const auto texels = static_cast<std::ptrdiff_t>(source.levelSize(level)) * source.levelSize(level);
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) {
    const float* from = source.face(level, face);
    faces[static_cast<std::size_t>(face)].assign(from, from + 4 * texels);
  }
  return irradianceCoefficients(faces, source.levelSize(level));
}

}  // namespace

ReferenceSky::ReferenceSky(const Sky& sky, std::shared_ptr<const ImageRgbaF> image, double rotationDegrees)
    : sky_(sky), image_(std::move(image)), rotation_(glm::radians(rotationDegrees)) {
  const int size = image_ ? kImageFaceSize : kFaceSize, samples = image_ ? kImageSamples : 1;
  CubeMap source(size, fullLevels(size));
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < size * size; ++i) {
      glm::vec3 sum(0.0f);
      for (int k = 0; k < samples * samples; ++k) {
        const auto place = [&](int texel, int sample) {
          return (2.0f * static_cast<float>(texel * samples + sample) + 1.0f) / static_cast<float>(size * samples) -
                 1.0f;
        };
        sum += radiance(shading::cubeDirection(face, place(i % size, k % samples), place(i / size, k / samples)));
      }
      source.setTexel(0, face, i % size, i / size, glm::vec4(sum / static_cast<float>(samples * samples), 0.0f));
    }
  }
  chain_ = prefilterCube(source, PrefilterSettings{});
  makeSourceLevels(source);
  irradiance_ = coefficientsOf(source);
}

// Bilinear, wrapped in longitude, clamped at the poles; the layout is that of shaders/gpu/sky.glsl.
glm::vec3 ReferenceSky::imageRadiance(const glm::vec3& d) const {
  if (!image_ || image_->width <= 0 || image_->height <= 0) return glm::vec3(0.0f);
  const double length = glm::length(glm::dvec3(d));
  const double longitude = std::atan2(static_cast<double>(d.x), static_cast<double>(d.z)) - rotation_;
  const double latitude = std::asin(std::clamp(length > 0.0 ? d.y / length : 0.0, -1.0, 1.0));
  constexpr double kPi = 3.14159265358979323846;
  const double x = (0.5 - longitude / (2.0 * kPi)) * image_->width - 0.5;
  const double y = (0.5 - latitude / kPi) * image_->height - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const float a = static_cast<float>(x - column), b = static_cast<float>(y - row);
  const auto texel = [&](int c, int r) {
    const int around = (c % image_->width + image_->width) % image_->width;
    const int clamped = std::clamp(r, 0, image_->height - 1);
    const float* p = &image_->pixels[(static_cast<std::size_t>(clamped) * static_cast<std::size_t>(image_->width) +
                                      static_cast<std::size_t>(around)) *
                                     4];
    return glm::vec3(p[0], p[1], p[2]);
  };
  const int c = static_cast<int>(column), r = static_cast<int>(row);
  return glm::mix(glm::mix(texel(c, r), texel(c + 1, r), a), glm::mix(texel(c, r + 1), texel(c + 1, r + 1), a), b);
}

glm::vec3 ReferenceSky::radiance(const glm::vec3& direction) const {
  if (const auto* color = std::get_if<SkyColor>(&sky_)) return color->color;
  if (const auto* g = std::get_if<SkyGradient>(&sky_)) {
    return shading::skyGradient(direction, g->top, g->horizon, g->ground);
  }
  return imageRadiance(direction);
}

glm::vec3 ReferenceSky::irradiance(const glm::vec3& n) const {
  const ShCoefficients& c = irradiance_;
  return shading::shIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
}

glm::vec3 ReferenceSky::reflection(const glm::vec3& direction, float roughness) const {
  return glm::vec3(chain_.fetch(direction, shading::levelForRoughness(roughness, chain_.maxLevel())));
}

}  // namespace boxprobe
