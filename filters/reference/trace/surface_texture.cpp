#include "filters/reference/trace/surface_texture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

// `i` is an integer, in a double because it may exceed an int.
int wrapped(double i, int size, Wrap wrap) {
  if (wrap == Wrap::ClampToEdge) return static_cast<int>(std::clamp(i, 0.0, size - 1.0));
  const int period = wrap == Wrap::MirroredRepeat ? 2 * size : size;
  const double rest = std::fmod(i, period);
  const int within = static_cast<int>(rest < 0.0 ? rest + period : rest);
  return within < size ? within : 2 * size - 1 - within;
}

glm::vec4 texel(const ImageRgba8& image, int column, int row, bool srgb) {
  const std::uint8_t* p = &image.pixels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                         static_cast<std::size_t>(column)) *
                                        4];
  const float alpha = static_cast<float>(p[3]) / 255.0f;
  if (!srgb) return glm::vec4(glm::vec3(p[0], p[1], p[2]) / 255.0f, alpha);
  return {linearOfSrgb(p[0]), linearOfSrgb(p[1]), linearOfSrgb(p[2]), alpha};
}

}  // namespace

glm::vec4 sampleTexture(const TextureUse& use, const glm::vec2& coordinates, bool srgb) {
  if (!use.image || use.image->width <= 0 || use.image->height <= 0) return glm::vec4(1.0f);
  const ImageRgba8& image = *use.image;
  const glm::dvec2 uv = glm::dmat3x2(use.uvTransform) * glm::dvec3(coordinates, 1.0);
  if (use.nearest && std::isfinite(uv.x) && std::isfinite(uv.y)) {
    return texel(image, wrapped(std::floor(uv.x * image.width), image.width, use.wrapS),
                 wrapped(std::floor(uv.y * image.height), image.height, use.wrapT), srgb);
  }
  const double x = uv.x * image.width - 0.5, y = uv.y * image.height - 0.5;
  if (!std::isfinite(x) || !std::isfinite(y)) return glm::vec4(0.0f);
  const double column = std::floor(x), row = std::floor(y);
  const float a = static_cast<float>(x - column), b = static_cast<float>(y - row);
  const int c0 = wrapped(column, image.width, use.wrapS), c1 = wrapped(column + 1.0, image.width, use.wrapS);
  const int r0 = wrapped(row, image.height, use.wrapT), r1 = wrapped(row + 1.0, image.height, use.wrapT);
  return glm::mix(glm::mix(texel(image, c0, r0, srgb), texel(image, c1, r0, srgb), a),
                  glm::mix(texel(image, c0, r1, srgb), texel(image, c1, r1, srgb), a), b);
}

}  // namespace boxprobe
