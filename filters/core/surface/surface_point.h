// The properties of a surface at one point, from which explanations, references and measures start.
#pragma once

#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace boxprobe {

/// A material's finish (MaterialFinish) at one point.
struct PointFinish {
  glm::vec3 f0{0.04f};  ///< of the non-metal
  float edge = 1.0f;    ///< reflectance of the non-metal at grazing angles
  bool tinted = false;  ///< `edge` is given by the material and does not follow from `f0`
  glm::vec3 sheenColor{0.0f};
  float sheenRoughness = 0.0f;
  glm::vec3 acrossWorld{0.0f};  ///< unit; the surface direction along which the microfacets' slopes vary least
  float anisotropy = 0.0f;
  float iridescence = 0.0f, filmIor = 1.3f;
  float filmThickness = 0.0f;  ///< nanometres

  bool hasSheen() const { return sheenColor != glm::vec3(0.0f); }
};

/// The surface where a pixel's ray meets it, read back from the shader, so textures and normal maps are included.
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
  float occlusion = 1.0f;  ///< factor of light from probes and sky
  float baseF0 = 0.04f;    ///< of the non-metal, from the index of refraction
  float opacity = 1.0f;
  float coatStrength = 0.0f;
  float coatRoughness = 0.0f;
  float coatF0 = 0.04f;
  glm::vec3 coatNormalWorld{0.0f};
  std::optional<PointFinish> finish;  ///< of materials that have one
  float transmission = 0.0f;          ///< of glass: fraction of light that is transmitted instead of scattered
  bool backSide = false;              ///< of glass: the eye sees the inner side of the surface
  glm::ivec2 pixel{0};  ///< of the picture, from its lower left: sampling techniques choose their rays by it
  int frame = 0;        ///< number of the averaged frame
};

}  // namespace boxprobe
