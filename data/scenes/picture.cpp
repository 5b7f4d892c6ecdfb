#include "data/scenes/picture.h"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "filters/core/base/errors.h"

namespace boxprobe::scenes {
namespace {

std::uint8_t srgbByte(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

void appendBytes(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

int wrapped(int i, int period) {
  return (i % period + period) % period;
}

}  // namespace

std::shared_ptr<const ImageRgba8> paint(const std::string& name, int width, int height, const Pattern& pattern,
                                        int samples) {
  auto image = std::make_shared<ImageRgba8>();
  image->name = name;
  image->width = width;
  image->height = height;
  image->pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      glm::dvec3 sum(0.0);
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
          sum += pattern((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height);
      sum /= samples * samples;
      for (int channel = 0; channel < 3; ++channel) image->pixels.push_back(srgbByte(sum[channel]));
      image->pixels.push_back(255);
    }
  }
  return image;
}

std::shared_ptr<const ImageRgba8> paintNumbers(const std::string& name, int width, int height, const Pattern& pattern) {
  auto image = std::make_shared<ImageRgba8>();
  image->name = name;
  image->width = width;
  image->height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 value = pattern((x + 0.5) / width, (y + 0.5) / height);
      for (int channel = 0; channel < 3; ++channel)
        image->pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value[channel], 0.0, 1.0))));
      image->pixels.push_back(255);
    }
  }
  return image;
}

std::string pngBytes(const ImageRgba8& image) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) opaque = opaque && image.pixels[i] == 255;
  const int components = opaque ? 3 : 4;
  std::vector<std::uint8_t> packed;
  packed.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (!opaque || i % 4 != 3) packed.push_back(image.pixels[i]);
  std::string bytes;
  // How far to search for repeats. A tenth smaller than by default; set back, since the library's users share it.
  const int usual = std::exchange(stbi_write_png_compression_level, 64);
  const int written = stbi_write_png_to_func(appendBytes, &bytes, image.width, image.height, components, packed.data(),
                                             image.width * components);
  stbi_write_png_compression_level = usual;
  if (written == 0) throw WorkError("picture " + image.name + ": could not be written as PNG");
  return bytes;
}

std::string jpegBytes(const ImageRgba8& image, int quality) {
  std::string bytes;
  if (stbi_write_jpg_to_func(appendBytes, &bytes, image.width, image.height, 4, image.pixels.data(), quality) == 0)
    throw WorkError("picture " + image.name + ": could not be written as JPEG");
  return bytes;
}

std::string hdrBytes(int width, int height, const std::vector<float>& rgb) {
  std::string bytes;
  if (!stbi_write_hdr_to_func(appendBytes, &bytes, width, height, 3, rgb.data()))
    throw WorkError("sky picture: could not be written as Radiance HDR");
  return bytes;
}

double softStep(double edge, double width, double x) {
  const double t = std::clamp((x - edge) / width + 0.5, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double softLines(double x, double period, double halfWidth, double width) {
  const double distance = std::abs(x - period * std::floor(x / period + 0.5));
  return 1.0 - softStep(halfWidth, width, distance);
}

// Two rounds of multiply and xor-shift: enough to hide the lattice, exact on every machine.
double hash(int x, int y, int seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u ^
                    static_cast<std::uint32_t>(seed) * 0xc2b2ae3du;
  for (int round = 0; round < 2; ++round) {
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 13;
  }
  return h / 4294967296.0;
}

double noise(double x, double y, int periodX, int periodY, int seed) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double fx = softStep(0.5, 1.0, x - x0), fy = softStep(0.5, 1.0, y - y0);
  const auto corner = [&](int i, int j) { return hash(wrapped(x0 + i, periodX), wrapped(y0 + j, periodY), seed); };
  const double bottom = corner(0, 0) + fx * (corner(1, 0) - corner(0, 0));
  const double top = corner(0, 1) + fx * (corner(1, 1) - corner(0, 1));
  return bottom + fy * (top - bottom);
}

glm::dvec3 blend(glm::dvec3 from, glm::dvec3 to, double amount) {
  return from + amount * (to - from);
}

}  // namespace boxprobe::scenes
