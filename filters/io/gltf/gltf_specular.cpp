// Converts KHR_materials_pbrSpecularGlossiness, which gives the reflection as a colour, to metallic-roughness, texel by
// texel. Source: the extension's text and its example (Khronos glTF repository,
// extensions/2.0/Archived/KHR_materials_pbrSpecularGlossiness).
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>

#include "filters/io/gltf/gltf_parts.h"
#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

constexpr float kDielectric = 0.04f;  // reflectance at normal incidence of index 1.5
constexpr float kTiny = 1.0e-6f;

float perceivedBrightness(const glm::vec3& c) {
  return std::sqrt(0.299f * c.r * c.r + 0.587f * c.g * c.g + 0.114f * c.b * c.b);
}

float metallicOf(float diffuse, float specular, float rest) {
  if (specular < kDielectric) return 0.0f;
  const float b = diffuse * rest / (1.0f - kDielectric) + specular - 2.0f * kDielectric;
  const float root = std::sqrt(std::max(b * b - 4.0f * kDielectric * (kDielectric - specular), 0.0f));
  return std::clamp((root - b) / (2.0f * kDielectric), 0.0f, 1.0f);
}

struct MetalRough {
  glm::vec3 baseColor{0.0f};
  float metallic = 0.0f;
};

MetalRough converted(const glm::vec3& diffuse, const glm::vec3& specular) {
  const float rest = 1.0f - std::max({specular.r, specular.g, specular.b});
  MetalRough result;
  result.metallic = metallicOf(perceivedBrightness(diffuse), perceivedBrightness(specular), rest);
  const float m = result.metallic;
  const glm::vec3 fromDiffuse = diffuse * (rest / (1.0f - kDielectric) / std::max(1.0f - m, kTiny));
  const glm::vec3 fromSpecular = (specular - kDielectric * (1.0f - m)) / std::max(m, kTiny);
  result.baseColor = glm::clamp(glm::mix(fromDiffuse, fromSpecular, m * m), 0.0f, 1.0f);
  return result;
}

std::uint8_t srgbByte(float linear) {
  const float v = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
}

/// Nearest texel; white without a picture.
glm::vec4 texelAt(const ImageRgba8* image, int x, int y, int width, int height) {
  if (image == nullptr) return glm::vec4(1.0f);
  const auto column = static_cast<std::size_t>(static_cast<long long>(x) * image->width / width);
  const auto row = static_cast<std::size_t>(static_cast<long long>(y) * image->height / height);
  const std::uint8_t* texel = image->pixels.data() + 4 * (row * static_cast<std::size_t>(image->width) + column);
  return {linearOfSrgb(texel[0]), linearOfSrgb(texel[1]), linearOfSrgb(texel[2]),
          static_cast<float>(texel[3]) / 255.0f};
}

struct Pictures {
  std::shared_ptr<const ImageRgba8> baseColor, roughMetal;
};

Pictures convertPictures(const ImageRgba8* diffuse, const ImageRgba8* specular, const GltfSpecularGlossiness& factors,
                         const glm::vec4& diffuseFactor) {
  const int width = std::max(diffuse != nullptr ? diffuse->width : 1, specular != nullptr ? specular->width : 1);
  const int height = std::max(diffuse != nullptr ? diffuse->height : 1, specular != nullptr ? specular->height : 1);
  auto color = std::make_shared<ImageRgba8>(), rough = std::make_shared<ImageRgba8>();
  for (ImageRgba8* made : {color.get(), rough.get()}) {
    made->width = width;
    made->height = height;
    made->name = diffuse != nullptr ? diffuse->name : specular->name;
    made->pixels.reserve(std::size_t(4) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec4 d = texelAt(diffuse, x, y, width, height) * diffuseFactor;
      const glm::vec4 s = texelAt(specular, x, y, width, height);
      const MetalRough result = converted(glm::vec3(d), glm::vec3(s) * factors.specular);
      const float roughness = 1.0f - s.a * factors.glossiness;
      const glm::vec3& c = result.baseColor;
      for (const std::uint8_t byte : {srgbByte(c.r), srgbByte(c.g), srgbByte(c.b),
                                      static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(d.a, 0.0f, 1.0f)))}) {
        color->pixels.push_back(byte);
      }
      for (const float value : {1.0f, roughness, result.metallic, 1.0f}) {
        rough->pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))));
      }
    }
  }
  return {color, rough};
}

}  // namespace

void convertSpecularGlossiness(Material& material, const GltfSpecularGlossiness& factors) {
  const auto diffuse = material.baseColorTexture.image, specular = material.metallicRoughnessTexture.image;
  if (!diffuse && !specular) {
    const MetalRough result = converted(glm::vec3(material.baseColor), factors.specular);
    material.baseColor = glm::vec4(result.baseColor, material.baseColor.a);
    material.metallic = result.metallic;
    material.roughness = 1.0f - factors.glossiness;
    return;
  }
  const Pictures pictures = convertPictures(diffuse.get(), specular.get(), factors, material.baseColor);
  if (!diffuse) material.baseColorTexture = material.metallicRoughnessTexture;
  if (!specular) material.metallicRoughnessTexture = material.baseColorTexture;
  material.baseColorTexture.image = pictures.baseColor;
  material.metallicRoughnessTexture.image = pictures.roughMetal;
  material.baseColor = glm::vec4(1.0f);
  material.metallic = material.roughness = 1.0f;
}

}  // namespace boxprobe
