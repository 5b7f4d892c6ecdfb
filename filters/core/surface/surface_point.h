// What a surface is at one point, whoever asks: explanations, references and measures all begin from it. Plain values;
// knows no probe.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace boxprobe {

/// A material's finish (MaterialFinish) at one point.
struct PointFinish {
  glm::vec3 f0{0.04f};  ///< of the non-metal
  float edge = 1.0f;    ///< what the non-metal reflects at a flat angle
  bool tinted = false;  ///< `edge` is the material's own, and does not follow from `f0`
  glm::vec3 sheenColor{0.0f};
  float sheenRoughness = 0.0f;
  glm::vec3 acrossWorld{0.0f};  ///< unit: the surface's direction across which the microfacets lean least
  float anisotropy = 0.0f;
  float iridescence = 0.0f, filmIor = 1.3f;
  float filmThickness = 0.0f;  ///< nanometres

  bool hasSheen() const { return sheenColor != glm::vec3(0.0f); }
};

/// What the surface is where a pixel's ray meets it: read from the shader itself, so textures and normal maps count.
struct SurfacePoint {
  std::string object;    ///< node name
  std::string material;  ///< material name
  glm::dvec3 positionWorld{0.0};
  glm::dvec3 eyeWorld{0.0};
  glm::vec3 normalWorld{0.0f};  ///< shading normal, unit; zero if the point has none
  glm::vec3 viewWorld{0.0f};    ///< towards the eye, unit
  glm::vec3 albedo{0.0f};
  glm::vec3 emissive{0.0f};
  float metallic = 0.0f;
  float roughness = 0.0f;  ///< perceptual
  float occlusion = 1.0f;  ///< factor of what comes from probes and sky
  float baseF0 = 0.04f;    ///< of the non-metal, from the index of refraction
  float opacity = 1.0f;
  float coatStrength = 0.0f;
  float coatRoughness = 0.0f;
  float coatF0 = 0.04f;
  glm::vec3 coatNormalWorld{0.0f};
  std::optional<PointFinish> finish;  ///< of materials that have one
  float transmission = 0.0f;          ///< of glass: share of the light that passes instead of being scattered
  bool backSide = false;              ///< of glass: the eye sees the inside of the surface
  glm::ivec2 pixel{0};  ///< of the picture, from its lower left: techniques that sample draw their rays by it
  int frame = 0;        ///< of those that are averaged
};

}  // namespace boxprobe
