// A model as plain arrays, whatever its file format: the source of VTK's actors and of the ray tracer's triangles.
#pragma once

#include <cstdint>
#include <glm/mat3x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// 8-bit RGBA, rows from the top of the picture down (glTF's v = 0 is the first row).
struct ImageRgba8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< width * height * 4
  std::string name;                  ///< for messages
};

/// Linear float RGBA, rows from the top of the picture down.
struct ImageRgbaF {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< width * height * 4
};

enum class Wrap { Repeat, ClampToEdge, MirroredRepeat };

struct TextureUse {
  std::shared_ptr<const ImageRgba8> image;  ///< null: no texture
  Wrap wrapS = Wrap::Repeat;
  Wrap wrapT = Wrap::Repeat;
  int uvSet = 0;                                                ///< which of the mesh's two sets of coordinates
  glm::mat3x2 uvTransform{1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};  ///< of (u, v, 1), by columns; KHR_texture_transform
  bool nearest = false;                                         ///< nearest-neighbour magnification
};

/// Meaning of a material's alpha (glTF 2.0, section 3.9.4).
enum class AlphaMode {
  Opaque,  ///< ignored
  Mask,    ///< fully opaque where alpha is at least the cutoff, else invisible
  Blend,   ///< coverage
};

/// Material properties beyond metalness and roughness; the defaults change nothing. Colours are linear, their textures
/// sRGB; a texture multiplies its factor by the channels named. Ignored on materials that transmit light.
struct MaterialFinish {
  glm::vec3 specularTint{1.0f};  ///< of a non-metal's normal reflectance: KHR_materials_specular
  float specularEdge = 1.0f;     ///< reflectance of a non-metal at grazing angles
  glm::vec3 sheenColor{0.0f};    ///< KHR_materials_sheen
  float sheenRoughness = 0.0f;
  float anisotropy = 0.0f;          ///< strength, 0 to 1: KHR_materials_anisotropy
  float anisotropyRotation = 0.0f;  ///< angle of the direction from the tangent, radians, towards the bitangent
  float iridescence = 0.0f;         ///< KHR_materials_iridescence
  float filmIor = 1.3f;
  float filmThicknessMin = 100.0f, filmThicknessMax = 400.0f;  ///< nanometres, over the texture's range
  TextureUse specularTexture, specularColorTexture;            ///< A, RGB
  TextureUse sheenColorTexture, sheenRoughnessTexture;         ///< RGB, A
  TextureUse anisotropyTexture;                                ///< RG: direction, 0.5 is none; B: strength
  TextureUse iridescenceTexture, filmThicknessTexture;         ///< R, G

  bool tintsSpecular() const;
  bool hasSheen() const { return sheenColor != glm::vec3(0.0f); }
  bool hasFilm() const { return iridescence > 0.0f; }
  bool isAnisotropic() const { return anisotropy > 0.0f; }
  bool any() const { return tintsSpecular() || hasSheen() || hasFilm() || isAnisotropic(); }
  /// All texture uses, including those without an image.
  std::vector<TextureUse*> textures();
};

/// glTF metallic-roughness. Colours linear; baseColor and emissive textures sRGB; metallicRoughness as glTF packs it
/// (G roughness, B metallic).
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f};
  float metallic = 1.0f;
  float roughness = 1.0f;    ///< perceptual
  glm::vec3 emissive{0.0f};  ///< factor times KHR_materials_emissive_strength: may exceed 1
  float normalScale = 1.0f;
  float occlusionStrength = 1.0f;
  float coat = 0.0f;
  float coatRoughness = 0.0f;
  float coatNormalScale = 1.0f;
  float transmission = 0.0f;  ///< KHR_materials_transmission
  float ior = 1.5f;
  float specular = 1.0f;       ///< factor of the reflectance that `ior` gives (KHR_materials_specular); may exceed 1
  bool thin = true;            ///< a sheet that does not bend light (KHR_materials_volume: thickness 0), not a solid
  float thickness = 0.0f;      ///< of a solid whose true thickness is unknown: scene units, mean over its texture
  float thicknessMean = 1.0f;  ///< mean of the texture: the local thickness is `thickness` times G over this
  float attenuationDistance = 0.0f;  ///< white light has attenuationColor left after this distance; 0: no absorption
  glm::vec3 attenuationColor{1.0f};
  GlassForm glass = GlassForm::Automatic;
  bool unlit = false;  ///< KHR_materials_unlit: shows baseColor times its texture, without light
  bool doubleSided = false;
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alphaCutoff = 0.5f;  ///< of AlphaMode::Mask
  TextureUse baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
  TextureUse coatTexture, coatRoughnessTexture, coatNormalTexture;  ///< R, G, a tangent-space normal
  TextureUse transmissionTexture, thicknessTexture;                 ///< R, G
  MaterialFinish finish;

  /// Does it show what lies behind it, refracted?
  bool transmits() const { return transmission > 0.0f && !unlit; }

  /// The index of refraction for which the normal reflectance is that of `ior` times `specular`.
  float reflectedIor() const;

  /// All texture uses, including those without an image.
  std::vector<TextureUse*> textures();
  std::vector<const TextureUse*> textures() const;
};

/// Triangles. Arrays other than positions are empty or have one entry per position.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;     ///< w = handedness, glTF convention
  std::vector<glm::vec2> uv;           ///< v = 0 at the top of the picture, as in glTF
  std::vector<glm::vec2> uv1;          ///< second set
  std::vector<glm::vec4> colors;       ///< linear, multiply the base colour and its alpha
  std::vector<std::uint32_t> indices;  ///< three per triangle
  int material = -1;                   ///< index into Model::materials, -1: the default material
};

/// A mesh placed in the world.
struct Instance {
  std::string node;  ///< glTF node name; what scene files call an object
  int mesh = 0;
  glm::dmat4 worldFromModel{1.0};
};

struct Model {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Light> lights;          ///< in the file's frame, as instances are
  std::vector<Camera> cameras;        ///< likewise, names unique
  std::vector<std::string> variants;  ///< names of the sets of materials to choose from
  double animationSeconds = 0.0;      ///< duration of the file's animations
  std::vector<std::string> warnings;  ///< unsupported features that the file uses, one line each

  std::size_t triangleCount() const;  ///< over all instances
};

}  // namespace boxprobe
