#include "filters/io/obj/mtl_material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

constexpr double kTwoPi = 6.283185307179586;

float unit(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// Rec. 709.
double luminance(const glm::dvec3& c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

TextureUse useOf(const MtlMap& map, std::shared_ptr<const ImageRgba8> image) {
  TextureUse use;
  use.image = std::move(image);
  if (map.clamp) use.wrapS = use.wrapT = Wrap::ClampToEdge;
  const auto sx = static_cast<float>(map.scale.x), sy = static_cast<float>(map.scale.y);
  const auto ox = static_cast<float>(map.offset.x), oy = static_cast<float>(map.offset.y);
  // v grows upwards in MTL and downwards here: 1 - (sy (1 - v) + oy).
  use.uvTransform = glm::mat3x2(sx, 0.0f, 0.0f, sy, ox, 1.0f - sy - oy);
  return use;
}

bool samePlace(const MtlMap& a, const MtlMap& b) {
  return a.offset == b.offset && a.scale == b.scale && a.clamp == b.clamp;
}

class Converter {
 public:
  Converter(const MtlMaterial& source, MtlPictures& pictures, std::set<std::string>& leftOut)
      : source_(source), pictures_(pictures), leftOut_(leftOut), physical_(isPhysical()) {}

  Material convert() {
    material_ = greyMaterial();
    material_.name = source_.name;
    illum_ = static_cast<int>(std::clamp(source_.number("illum").value_or(2.0), 0.0, 10.0));
    takeColor();
    takeRoughAndMetal();
    takeReflection();
    takeOpacity();
    takeGlow();
    takeNormals();
    takeCoatAndSheen();
    takeOcclusion();
    if (illum_ == 0 && source_.number("illum")) material_.unlit = true;
    if (illum_ == 10) leftOut_.insert("illum 10");
    return std::move(material_);
  }

 private:
  bool isPhysical() const {
    for (const char* key : {"pr", "pm"}) {
      if (source_.number(key)) return true;
    }
    for (const char* key : {"map_pr", "map_pm", "map_rma", "map_orm"}) {
      if (source_.map(key) != nullptr) return true;
    }
    return false;
  }

  void takeColor() {
    const glm::dvec3* kd = source_.color("kd");
    const MtlMap* map = source_.map("map_kd");
    glm::dvec3 color = kd != nullptr ? *kd : map != nullptr ? glm::dvec3(1.0) : glm::dvec3(material_.baseColor);
    if (map != nullptr) {
      if (std::shared_ptr<const ImageRgba8> image = pictures_.color(*map)) {
        material_.baseColorTexture = useOf(*map, std::move(image));
        color = shownThrough(color, "Kd");
      } else {
        constexpr double kGrey = 0.2159;  // sRGB's middle grey
        color = glm::dvec3(kGrey);
      }
    }
    material_.baseColor = glm::vec4(glm::vec3(color), 1.0f);
  }

  /// Many programs write a factor of 0 beside a picture, which would never show.
  glm::dvec3 shownThrough(const glm::dvec3& factor, const char* key) {
    if (factor != glm::dvec3(0.0)) return factor;
    leftOut_.insert(std::string(key) + " 0 beside a picture (taken as 1)");
    return glm::dvec3(1.0);
  }
  double factorOf(const char* key, const char* written, bool pictured) {
    const double factor = source_.number(key).value_or(1.0);
    return pictured ? shownThrough(glm::dvec3(factor), written).x : factor;
  }

  void takeRoughAndMetal() {
    const double shininess = std::max(source_.number("ns").value_or(0.0), 0.0);
    const double otherwise =
        physical_ && !source_.number("ns") ? 0.5 : static_cast<double>(roughnessOfShininess(shininess));
    material_.roughness = unit(source_.number("pr").value_or(otherwise));
    material_.metallic = unit(source_.number("pm").value_or(0.0));
    for (const char* key : {"map_rma", "map_orm"}) {
      if (const MtlMap* map = source_.map(key)) {
        takePacked(*map, key == std::string("map_rma"));
        return;
      }
    }
    const MtlMap *rough = source_.map("map_pr"), *metal = source_.map("map_pm"), *shine = source_.map("map_ns");
    ScalarPicture roughness, metalness;
    std::string key;
    if (rough != nullptr) roughness = pictures_.scalar(onePicture(*rough, metal, 'g'));
    if (metal != nullptr) metalness = pictures_.scalar(onePicture(*metal, rough, 'b'));
    if (!roughness.values.empty()) {
      key = "rough " + pictures_.keyOf(onePicture(*rough, metal, 'g'));
      material_.roughness = unit(factorOf("pr", "Pr", true));
    } else if (rough == nullptr && !source_.number("pr") && shine != nullptr) {
      roughness = pictures_.scalar(*shine);
      for (float& value : roughness.values) value = roughnessOfShininess(shininess * static_cast<double>(value));
      if (!roughness.values.empty()) {
        key = "shininess " + std::to_string(shininess) + pictures_.keyOf(*shine);
        material_.roughness = 1.0f;
        rough = shine;
      }
    }
    if (!metalness.values.empty()) {
      if (!roughness.values.empty() && !samePlace(*rough, *metal)) {
        leftOut_.insert("options of map_Pm other than those of the roughness picture");
      }
      key += "metal " + pictures_.keyOf(onePicture(*metal, source_.map("map_pr"), 'b'));
      material_.metallic = unit(factorOf("pm", "Pm", true));
    }
    if (roughness.values.empty() && metalness.values.empty()) return;
    material_.metallicRoughnessTexture =
        useOf(roughness.values.empty() ? *metal : *rough, pictures_.packed(key, {}, roughness, metalness));
  }

  /// One picture for both holds them in glTF's channels.
  static MtlMap onePicture(const MtlMap& map, const MtlMap* other, char channel) {
    MtlMap result = map;
    if (other != nullptr && other->name == map.name && map.channel == '\0' && other->channel == '\0') {
      result.channel = channel;
    }
    return result;
  }

  /// Roughness, metalness, occlusion in red, green, blue; or occlusion, roughness, metalness.
  void takePacked(const MtlMap& map, bool roughFirst) {
    const auto channel = [&](char name) {
      MtlMap one = map;
      one.channel = name;
      return pictures_.scalar(one);
    };
    const ScalarPicture rough = channel(roughFirst ? 'r' : 'g'), metal = channel(roughFirst ? 'g' : 'b');
    const ScalarPicture occlusion = channel(roughFirst ? 'b' : 'r');
    if (rough.values.empty()) return;
    const TextureUse use =
        useOf(map, pictures_.packed((roughFirst ? "rma " : "orm ") + pictures_.keyOf(map), occlusion, rough, metal));
    material_.metallicRoughnessTexture = material_.occlusionTexture = use;
    material_.roughness = unit(factorOf("pr", "Pr", true));
    material_.metallic = unit(factorOf("pm", "Pm", true));
  }

  /// Ks: of mirrors (illum 3 to 9) the reflectance at normal incidence, of plastic the strength of its highlights,
  /// where 0.5 is glTF's 1, as Blender writes it. Physically based metals have none.
  void takeReflection() {
    if (illum_ == 1) material_.specular = 0.0f;  // Lambert
    const glm::dvec3* ks = source_.color("ks");
    const bool mirror = illum_ >= 3 && illum_ <= 9;
    const MtlMap* map = source_.map("map_ks");
    if (illum_ < 2 || (ks == nullptr && map == nullptr)) {
      if (map != nullptr) leftOut_.insert("map_Ks of illum 0 and 1");
      return;
    }
    glm::dvec3 specular = ks != nullptr ? *ks : glm::dvec3(0.5);
    if (mirror && !physical_ && map == nullptr) {
      takeMirror(specular);
      return;
    }
    std::shared_ptr<const ImageRgba8> image = map != nullptr ? pictures_.color(*map) : nullptr;
    if (image) {
      specular = shownThrough(specular, "Ks");
      material_.finish.specularColorTexture = useOf(*map, std::move(image));
    }
    const double brightness = luminance(specular);
    material_.specular = static_cast<float>(2.0 * brightness);
    const glm::dvec3 away = glm::abs(specular - brightness);
    // Almost grey counts as grey, because a tint needs a program of its own.
    if (brightness > 0.0 && std::max({away.r, away.g, away.b}) > 1e-3 * brightness) {
      material_.finish.specularTint = glm::vec3(specular / brightness);
    }
  }

  /// Diffuse and specular reflectance as a base colour and a metalness: the example of Khronos'
  /// KHR_materials_pbrSpecularGlossiness.
  void takeMirror(const glm::dvec3& ks) {
    constexpr double kPlastic = 0.04, kTiny = 1e-6;
    const double strongest = std::max({ks.r, ks.g, ks.b});
    if (strongest <= kPlastic) {
      material_.specular = static_cast<float>(strongest / kPlastic);
      return;
    }
    if (material_.baseColorTexture.image) {
      // The picture is of the diffuse part: its surface stays a plastic as shiny as can be.
      material_.specular = static_cast<float>(luminance(ks) / kPlastic);
      return;
    }
    const auto perceived = [](const glm::dvec3& c) {
      return std::sqrt(0.299 * c.r * c.r + 0.587 * c.g * c.g + 0.114 * c.b * c.b);
    };
    const glm::dvec3 kd(material_.baseColor);
    const double rest = 1.0 - strongest, specular = perceived(ks);
    const double b = perceived(kd) * rest / (1.0 - kPlastic) + specular - 2.0 * kPlastic;
    const double root = std::sqrt(std::max(b * b - 4.0 * kPlastic * (kPlastic - specular), 0.0));
    const double metal = specular < kPlastic ? 0.0 : std::clamp((root - b) / (2.0 * kPlastic), 0.0, 1.0);
    const glm::dvec3 diffuse = kd * (rest / (1.0 - kPlastic) / std::max(1.0 - metal, kTiny));
    const glm::dvec3 reflected = (ks - kPlastic * (1.0 - metal)) / std::max(metal, kTiny);
    const glm::dvec3 color = glm::clamp(glm::mix(diffuse, reflected, metal * metal), 0.0, 1.0);
    material_.metallic = static_cast<float>(metal);
    material_.baseColor = glm::vec4(glm::vec3(color), material_.baseColor.a);
  }

  /// d, else 1 - Tr. Glass (illum 4, 6, 7, 9) with a filter or an index of refraction lets light through; other
  /// surfaces cover what is behind them in part.
  void takeOpacity() {
    const std::optional<double> d = source_.number("d"), tr = source_.number("tr");
    if (!d && tr && *tr == 1.0) leftOut_.insert("Tr 1 without d (taken as opaque)");
    const double opacity = std::clamp(d ? *d : tr && *tr != 1.0 ? 1.0 - *tr : 1.0, 0.0, 1.0);
    const glm::dvec3* filter = source_.color("tf");
    const double index = source_.number("ni").value_or(1.0);
    const bool refracts = (illum_ == 6 || illum_ == 7) && index > 1.0, thin = illum_ == 4 || illum_ == 9;
    if (opacity < 1.0 && !physical_ && (refracts || (thin && filter != nullptr))) {
      constexpr double kLargestIndex = 4.0;
      material_.transmission = static_cast<float>(1.0 - opacity);
      material_.thin = !refracts;
      if (index > 1.0) material_.ior = static_cast<float>(std::min(index, kLargestIndex));
      material_.metallic = 0.0f;
      material_.specular = 1.0f;
      const glm::vec3 through = filter != nullptr ? glm::vec3(*filter) : glm::vec3(1.0f);
      material_.baseColor = glm::vec4(glm::mix(glm::vec3(material_.baseColor), through, material_.transmission), 1.0f);
      if (source_.map("map_d") != nullptr) leftOut_.insert("map_d of glass");
      return;
    }
    if (filter != nullptr && *filter != glm::dvec3(1.0)) leftOut_.insert("Tf of what is no glass");
    material_.baseColor.a = static_cast<float>(opacity);
    if (opacity < 1.0) material_.alphaMode = AlphaMode::Blend;
    takeMask(opacity);
  }

  void takeMask(double opacity) {
    const MtlMap *map = source_.map("map_d"), *color = source_.map("map_kd");
    if (map == nullptr) return;
    const ScalarPicture mask = pictures_.scalar(*map, true);
    if (mask.values.empty()) return;
    if (color != nullptr && material_.baseColorTexture.image && !samePlace(*map, *color)) {
      leftOut_.insert("options of map_d other than those of map_Kd");
    }
    const std::string key = pictures_.keyOf(*map) + (color != nullptr ? "\n" + pictures_.keyOf(*color) : "");
    TextureUse& use = material_.baseColorTexture;
    std::shared_ptr<const ImageRgba8> image = pictures_.masked(key, use.image, mask);
    if (use.image) {
      use.image = std::move(image);
    } else {
      use = useOf(*map, std::move(image));
    }
    if (opacity == 0.0) {
      material_.baseColor.a = 1.0f;
      leftOut_.insert("d 0 beside a picture (taken as 1)");
    }
    // What is cut out needs no sorting: almost all texels are there or not.
    std::size_t between = 0;
    for (const float value : mask.values) between += value > 0.0625f && value < 0.9375f ? 1 : 0;
    const bool cut = between * 10 <= mask.values.size() && (opacity == 1.0 || opacity == 0.0);
    material_.alphaMode = cut ? AlphaMode::Mask : AlphaMode::Blend;
    material_.alphaCutoff = 0.5f;
  }

  void takeGlow() {
    const glm::dvec3* ke = source_.color("ke");
    const MtlMap* map = source_.map("map_ke");
    if (ke != nullptr) material_.emissive = glm::vec3(*ke);
    std::shared_ptr<const ImageRgba8> image = map != nullptr ? pictures_.color(*map) : nullptr;
    if (!image) return;
    material_.emissiveTexture = useOf(*map, std::move(image));
    material_.emissive = glm::vec3(ke != nullptr ? shownThrough(*ke, "Ke") : glm::dvec3(1.0));
  }

  void takeNormals() {
    for (const char* key : {"norm", "map_bump"}) {
      const MtlMap* map = source_.map(key);
      if (map == nullptr) continue;
      if (material_.normalTexture.image) {
        leftOut_.insert("map_Bump beside norm");
        return;
      }
      float strength = static_cast<float>(map->bump);
      std::shared_ptr<const ImageRgba8> image = pictures_.normals(*map, key != std::string("norm"), strength);
      if (!image) continue;
      material_.normalTexture = useOf(*map, std::move(image));
      material_.normalScale = strength;
    }
  }

  /// A picture of one scalar in all channels.
  TextureUse scalarUse(const char* key) {
    const MtlMap* map = source_.map(key);
    if (map == nullptr) return {};
    const ScalarPicture picture = pictures_.scalar(*map);
    if (picture.values.empty()) return {};
    return useOf(*map, pictures_.packed("scalar " + pictures_.keyOf(*map), picture, picture, picture));
  }

  void takeCoatAndSheen() {
    constexpr float kSheenRoughness = 0.5f;  // MTL has none
    material_.coatTexture = scalarUse("map_pc");
    material_.coatRoughnessTexture = scalarUse("map_pcr");
    const auto factor = [&](const char* key, const char* written, const TextureUse& use) {
      return use.image ? unit(factorOf(key, written, true)) : unit(source_.number(key).value_or(0.0));
    };
    material_.coat = factor("pc", "Pc", material_.coatTexture);
    material_.coatRoughness = factor("pcr", "Pcr", material_.coatRoughnessTexture);
    if (const MtlMap* map = source_.map("map_ps")) {
      if (std::shared_ptr<const ImageRgba8> image = pictures_.color(*map)) {
        material_.finish.sheenColorTexture = useOf(*map, std::move(image));
      }
    }
    material_.finish.sheenColor = glm::vec3(factor("ps", "Ps", material_.finish.sheenColorTexture));
    if (material_.finish.hasSheen()) material_.finish.sheenRoughness = kSheenRoughness;
    material_.finish.anisotropy = unit(source_.number("aniso").value_or(0.0));
    material_.finish.anisotropyRotation =
        static_cast<float>(kTwoPi * std::fmod(source_.number("anisor").value_or(0.0), 1.0));
  }

  void takeOcclusion() {
    if (const MtlMap* map = source_.map("map_ao")) {
      if (std::shared_ptr<const ImageRgba8> image = pictures_.color(*map)) {
        material_.occlusionTexture = useOf(*map, std::move(image));
      }
    }
    // Ambient light: that of sky and probes takes its place. Programs write these values for it by default.
    const glm::dvec3 *ka = source_.color("ka"), *kd = source_.color("kd");
    if (ka == nullptr || (kd != nullptr && *ka == *kd)) return;
    const bool usual = ka->r == ka->g && ka->g == ka->b && (ka->r == 0.0 || ka->r == 0.2 || ka->r == 1.0);
    if (!usual) leftOut_.insert("Ka");
  }

  const MtlMaterial& source_;
  MtlPictures& pictures_;
  std::set<std::string>& leftOut_;
  const bool physical_;
  Material material_;
  int illum_ = 2;
};

}  // namespace

Material greyMaterial() {
  Material material;
  material.name = "default";
  material.baseColor = {0.8f, 0.8f, 0.8f, 1.0f};
  material.metallic = 0.0f;
  material.roughness = 0.5f;
  material.doubleSided = true;
  return material;
}

Material whiteMaterial() {
  Material material = greyMaterial();
  material.baseColor = glm::vec4(1.0f);
  material.roughness = 1.0f;
  return material;
}

float roughnessOfShininess(double shininess) {
  return static_cast<float>(std::pow(2.0 / (std::max(shininess, 0.0) + 2.0), 0.25));
}

Material materialOfMtl(const MtlMaterial& source, MtlPictures& pictures, std::set<std::string>& leftOut) {
  return Converter(source, pictures, leftOut).convert();
}

}  // namespace boxprobe
