// Materials, textures and images out of glTF files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/image/image_pool.h"
#include "tests/unit/error_text.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

class ModelMaterial : public TemporaryFolder {
 protected:
  ModelMaterial() { glb.triangle({{"material", 0}}); }
  Model load() const {
    write("m.glb", glb.glb());
    return loadModelFile(file("m.glb"));
  }
  Material material(const Json& json) {
    glb.json["materials"] = Json::array({json});
    return load().materials.at(0);
  }
  /// PNG bytes of a 2 x 1 picture: red, then green at half opacity.
  std::string picture() const {
    ImageRgba8 image;
    image.width = 2;
    image.height = 1;
    image.pixels = {255, 0, 0, 255, 0, 255, 0, 128};
    savePng(file("made.png"), image);
    return read("made.png");
  }
  GlbBuilder glb;
};

TEST_F(ModelMaterial, DefaultsAreTheStandards) {
  const Material m = material({{"name", "plain"}});
  EXPECT_EQ(m.name, "plain");
  EXPECT_EQ(m.baseColor, glm::vec4(1.0f));
  EXPECT_EQ(m.metallic, 1.0f);
  EXPECT_EQ(m.roughness, 1.0f);
  EXPECT_EQ(m.emissive, glm::vec3(0.0f));
  EXPECT_EQ(m.ior, 1.5f);
  EXPECT_FALSE(m.unlit || m.doubleSided);
  EXPECT_FALSE(m.baseColorTexture.image);
  EXPECT_EQ(material(Json::object()).name, "material0");
}

TEST_F(ModelMaterial, FactorsAndExtensions) {
  const Material m =
      material({{"name", "all"},
                {"doubleSided", true},
                {"emissiveFactor", {1, 0.5, 0.25}},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}},
                {"extensions",
                 {{"KHR_materials_unlit", Json::object()},
                  {"KHR_materials_emissive_strength", {{"emissiveStrength", 40}}},
                  {"KHR_materials_ior", {{"ior", 1.33}}},
                  {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                  {"KHR_materials_volume",
                   {{"thicknessFactor", 0.5}, {"attenuationDistance", 3}, {"attenuationColor", {0.25, 0.5, 1}}}},
                  {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.75}, {"clearcoatRoughnessFactor", 0.125}}}}}});
  EXPECT_EQ(m.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.roughness, 0.25f);
  EXPECT_EQ(m.emissive, glm::vec3(40.0f, 20.0f, 10.0f));
  EXPECT_EQ(m.ior, 1.33f);
  EXPECT_EQ(m.transmission, 1.0f);
  EXPECT_FALSE(m.thin);
  EXPECT_EQ(m.thickness, 0.5f);
  EXPECT_EQ(m.attenuationDistance, 3.0f);
  EXPECT_EQ(m.attenuationColor, glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(m.coat, 0.75f);
  EXPECT_EQ(m.coatRoughness, 0.125f);
  EXPECT_TRUE(m.unlit && m.doubleSided);
}

TEST_F(ModelMaterial, TexturesOfEverySlotFromTheBufferAndShared) {
  const std::string png = picture();
  const int view = glb.view(std::vector<char>(png.begin(), png.end()));
  glb.json["images"] = Json::array({{{"bufferView", view}, {"mimeType", "image/png"}, {"name", "checks"}}});
  glb.json["samplers"] = Json::array({{{"wrapS", 33071}, {"wrapT", 33648}}});
  glb.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}, {{"source", 0}}});
  const Material m = material(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 1}}}}},
       {"normalTexture", {{"index", 1}, {"scale", 0.5}}},
       {"occlusionTexture", {{"index", 1}, {"strength", 0.25}}},
       {"emissiveTexture", {{"index", 1}}}});
  ASSERT_TRUE(m.baseColorTexture.image);
  EXPECT_EQ(m.baseColorTexture.image->width, 2);
  EXPECT_EQ(m.baseColorTexture.image->pixels, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 128}));
  EXPECT_EQ(m.baseColorTexture.image->name, "checks");
  EXPECT_EQ(m.baseColorTexture.wrapS, Wrap::ClampToEdge);
  EXPECT_EQ(m.baseColorTexture.wrapT, Wrap::MirroredRepeat);
  EXPECT_EQ(m.normalTexture.wrapS, Wrap::Repeat);
  EXPECT_EQ(m.normalScale, 0.5f);
  EXPECT_EQ(m.occlusionStrength, 0.25f);
  for (const TextureUse* use :
       {&m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture}) {
    EXPECT_EQ(use->image, m.baseColorTexture.image);  // decoded once
  }
}

TEST_F(ModelMaterial, SpecularReflectanceIsThatOfItsFactors) {
  const auto reflectance = [](const Material& m) {
    const float root = (m.reflectedIor() - 1.0f) / (m.reflectedIor() + 1.0f);
    return root * root;
  };
  const auto of = [&](const Json& extensions) { return material({{"extensions", extensions}}); };
  EXPECT_EQ(of({{"KHR_materials_ior", {{"ior", 1.7}}}}).reflectedIor(), 1.7f) << "untouched without the extension";
  const Material half =
      of({{"KHR_materials_specular", {{"specularFactor", 0.5}}}, {"KHR_materials_ior", {{"ior", 2}}}});
  EXPECT_NEAR(reflectance(half), 0.5f / 9.0f, 1e-6f);
  EXPECT_EQ(half.ior, 2.0f) << "refraction keeps the index";
  EXPECT_NEAR(reflectance(of({{"KHR_materials_specular", {{"specularFactor", 0}}}})), 0.0f, 1e-7f);
  EXPECT_NEAR(reflectance(of({{"KHR_materials_ior", {{"ior", 0}}}})), 1.0f, 1e-5f) << "an index of 0 means a mirror";
  const Json grey = {{"specularColorFactor", {0.25, 0.25, 0.25}}};
  EXPECT_NEAR(reflectance(of({{"KHR_materials_ior", {{"ior", 0}}}, {"KHR_materials_specular", grey}})), 0.25f, 1e-5f);
  EXPECT_FALSE(of({{"KHR_materials_specular", grey}}).finish.any()) << "a grey needs no program of its own";
  EXPECT_TRUE(load().warnings.empty());
  const Material red = of({{"KHR_materials_specular", {{"specularColorFactor", {1, 0, 0}}}}});
  EXPECT_TRUE(load().warnings.empty());
  EXPECT_NEAR(0.04f * red.specular * red.finish.specularTint.r, 0.04f, 1e-5f);
  EXPECT_EQ(red.finish.specularTint.g, 0.0f);
}

// Out of range is brought into it, whole extensions of nothing change nothing.
TEST_F(ModelMaterial, AFinishKeepsToItsRanges) {
  const auto of = [&](const Json& extensions) { return material({{"extensions", extensions}}).finish; };
  EXPECT_FALSE(of({{"KHR_materials_sheen", Json::object()},
                   {"KHR_materials_anisotropy", Json::object()},
                   {"KHR_materials_iridescence", Json::object()},
                   {"KHR_materials_specular", Json::object()}})
                   .any());
  const MaterialFinish wild =
      of({{"KHR_materials_sheen", {{"sheenColorFactor", {-1, 2, 0.5}}, {"sheenRoughnessFactor", 7}}},
          {"KHR_materials_anisotropy", {{"anisotropyStrength", -3}, {"anisotropyRotation", 1e30}}},
          {"KHR_materials_iridescence",
           {{"iridescenceFactor", 2}, {"iridescenceIor", -1}, {"iridescenceThicknessMaximum", -5}}}});
  EXPECT_EQ(wild.sheenColor, glm::vec3(0.0f, 1.0f, 0.5f));
  EXPECT_EQ(wild.sheenRoughness, 1.0f);
  EXPECT_FALSE(wild.isAnisotropic());
  EXPECT_TRUE(std::isfinite(wild.anisotropyRotation));
  EXPECT_EQ(wild.iridescence, 1.0f);
  EXPECT_EQ(wild.filmIor, 1.0f);
  EXPECT_EQ(wild.filmThicknessMax, 0.0f);
  of({{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
      {"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}}}});
  EXPECT_NE(load().warnings.at(0).find("glass with"), std::string::npos);
}

// Plastic stays what it is, a mirror of gold becomes a metal of its colour (the values follow from the extension's
// formulas: no diffuse light and a reflectance far above plastic's mean metallic 1).
TEST_F(ModelMaterial, SpecularGlossinessBecomesMetallicRoughness) {
  const auto of = [&](const Json& values) {
    return material({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", values}}}});
  };
  const Material plastic = of({{"diffuseFactor", {0.5, 0.25, 0.125, 0.75}},
                               {"specularFactor", {0.04, 0.04, 0.04}},
                               {"glossinessFactor", 0.75}});
  EXPECT_NEAR(plastic.metallic, 0.0f, 1e-4f);
  EXPECT_NEAR(plastic.roughness, 0.25f, 1e-6f);
  EXPECT_NEAR(plastic.baseColor.r, 0.5f, 1e-3f);
  EXPECT_EQ(plastic.baseColor.a, 0.75f);
  const Material gold =
      of({{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1, 0.766, 0.336}}, {"glossinessFactor", 1}});
  EXPECT_NEAR(gold.metallic, 1.0f, 1e-4f);
  EXPECT_NEAR(gold.baseColor.g, 0.766f, 1e-3f);
  EXPECT_EQ(gold.roughness, 0.0f);
  picture();
  glb.json["images"] = Json::array({{{"uri", "made.png"}}});
  glb.json["textures"] = Json::array({{{"source", 0}}});
  const Material textured = of({{"specularFactor", {0.04, 0.04, 0.04}}, {"specularGlossinessTexture", {{"index", 0}}}});
  ASSERT_TRUE(textured.metallicRoughnessTexture.image && textured.baseColorTexture.image);
  EXPECT_EQ(textured.metallicRoughnessTexture.image->pixels[1], 0) << "alpha 1 is full gloss";
  EXPECT_EQ(textured.metallicRoughnessTexture.image->pixels[5], 127) << "alpha 128 is half of it";
  // Of plastic the diffuse colours stay, channel by channel.
  const Material colored = of({{"specularFactor", {0.04, 0.04, 0.04}}, {"diffuseTexture", {{"index", 0}}}});
  const Material plain = material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  ASSERT_TRUE(colored.baseColorTexture.image && plain.baseColorTexture.image);
  const std::vector<std::uint8_t>& was = plain.baseColorTexture.image->pixels;
  ASSERT_EQ(colored.baseColorTexture.image->pixels.size(), was.size());
  for (std::size_t i = 0; i < was.size(); ++i) {
    EXPECT_NEAR(colored.baseColorTexture.image->pixels[i], was[i], 1) << i;
  }
}

TEST_F(ModelMaterial, AThicknessTextureCountsByItsMean) {
  picture();  // green: 0 and 255
  glb.json["images"] = Json::array({{{"uri", "made.png"}}});
  glb.json["textures"] = Json::array({{{"source", 0}}});
  const Json volume = {{"thicknessFactor", 3}, {"thicknessTexture", {{"index", 0}}}};
  const Material m = material({{"extensions", {{"KHR_materials_volume", volume}}}});
  EXPECT_NEAR(m.thickness, 1.5f, 1e-6f);
  EXPECT_FALSE(m.thin);
}

TEST_F(ModelMaterial, AnEmissiveTextureNeedsNoBaseColorTexture) {
  picture();
  glb.json["images"] = Json::array({{{"uri", "made.png"}}});
  glb.json["textures"] = Json::array({{{"source", 0}}});
  const Material m = material({{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}});
  ASSERT_TRUE(m.emissiveTexture.image);
  EXPECT_EQ(m.emissiveTexture.image->pixels[0], 255);
  EXPECT_FALSE(m.baseColorTexture.image);
}

TEST_F(ModelMaterial, ImagesThatCannotBeReadAreNamed) {
  glb.json["textures"] = Json::array({{{"source", 0}}});
  glb.json["materials"] = Json::array({{{"emissiveTexture", {{"index", 0}}}}});
  glb.json["images"] = Json::array({{{"uri", "gone.png"}}});
  const Model gone = load();
  ASSERT_EQ(gone.warnings.size(), 1u);
  EXPECT_EQ(gone.warnings[0], "has the texture gone.png, which does not exist; grey takes its place");
  EXPECT_FALSE(gone.materials[0].emissiveTexture.image);
  const Material grey = material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                  {"emissiveFactor", {1, 1, 1}},
                                  {"emissiveTexture", {{"index", 0}}}});
  ASSERT_TRUE(grey.baseColorTexture.image);
  EXPECT_EQ(grey.baseColorTexture.image->pixels, (std::vector<std::uint8_t>{128, 128, 128, 255}));
  EXPECT_EQ(grey.emissive, glm::vec3(0.0f)) << "a picture that is missing does not glow";
  picture();
  std::filesystem::create_directory(folder_ / "sub");
  std::filesystem::rename(file("made.png"), file("sub/made.png"));
  glb.json["images"] = Json::array({{{"uri", "sub\\made.png"}}});
  EXPECT_TRUE(load().warnings.empty()) << "separators as Windows writes them";
  glb.json["materials"] = Json::array({{{"emissiveTexture", {{"index", 0}}}}});

  write("text.png", "not a picture");
  glb.json["images"] = Json::array({{{"uri", "text.png"}}});
  const Model text = load();  // one picture does not refuse a model
  ASSERT_EQ(text.warnings.size(), 1u);
  EXPECT_EQ(
      text.warnings[0],
      "image 0 (text.png): is not a PNG, JPEG or WebP picture; save it as one of these; grey takes its place, or it "
      "is left out");
  EXPECT_FALSE(text.materials[0].emissiveTexture.image);
  EXPECT_EQ(text.materials[0].emissive, glm::vec3(0.0f));
  const Material textual = material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  ASSERT_TRUE(textual.baseColorTexture.image);
  EXPECT_EQ(textual.baseColorTexture.image->pixels, (std::vector<std::uint8_t>{128, 128, 128, 255}));

  const int view = glb.view(std::vector<char>{'x'});
  glb.json["bufferViews"][view]["byteLength"] = 1000000;
  glb.json["images"] = Json::array({{{"bufferView", view}, {"mimeType", "image/png"}}});
  EXPECT_NE(errorText([&] { load(); }).find("runs past the end of buffer 0"), std::string::npos);
}

TEST_F(ModelMaterial, FilesOutsideTheModelsFolderAreNotRead) {
  const std::string png = picture();
  write("secret.png", png);
  write("inside/m.glb", "");
  glb.json["textures"] = Json::array({{{"source", 0}}});
  glb.json["materials"] = Json::array({{{"emissiveTexture", {{"index", 0}}}}});
  const auto loadWith = [&](const std::string& uri) {
    glb.json["images"] = Json::array({{{"uri", uri}}});
    write("inside/m.glb", glb.glb());
    return errorText([&] { loadModelFile(file("inside/m.glb")); });
  };
  EXPECT_NE(loadWith("../secret.png").find("lies outside the model's folder; put it inside"), std::string::npos);
  EXPECT_NE(loadWith("%2e%2e/secret.png").find("lies outside the model's folder"), std::string::npos);
  EXPECT_NE(loadWith(file("secret.png")), "");
  std::filesystem::create_symlink(file("secret.png"), folder_ / "inside" / "link.png");
  EXPECT_NE(loadWith("link.png").find("lies outside the model's folder"), std::string::npos);
}

TEST_F(ModelMaterial, WhatIsNotSupportedIsNamedOnce) {
  picture();
  glb.json["images"] = Json::array({{{"uri", "made.png"}}});
  glb.json["textures"] = Json::array({{{"source", 0}}, {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}});
  const Json m = {
      {"alphaMode", "DITHER"},
      {"emissiveTexture", {{"index", 0}, {"texCoord", 2}}},
      {"normalTexture", {{"index", 1}}},
      {"extensions",
       {{"KHR_materials_transmission", {{"transmissionFactor", 1}, {"transmissionTexture", {{"index", 0}}}}}}}};
  glb.json["materials"] = Json::array({m, m});
  const Model model = load();
  std::string all;
  for (const std::string& warning : model.warnings) all += warning + "\n";
  EXPECT_EQ(model.warnings.size(), 3u) << all;
  for (const char* word : {"alphaMode DITHER", "third set of texture coordinates", "without a PNG, JPEG or WebP"}) {
    EXPECT_NE(all.find(word), std::string::npos) << word << " in " << all;
  }
  EXPECT_TRUE(model.materials[0].emissiveTexture.image);
  EXPECT_FALSE(model.materials[0].normalTexture.image);
}

/// A file of several pictures, two of them the same bytes.
class ManyPictures : public ModelMaterial {
 protected:
  void make(int count) {
    for (int i = 0; i < count; ++i) {
      const std::string name = "p" + std::to_string(i) + ".png";
      savePng(file(name), ImageRgba8{1, 1, {static_cast<std::uint8_t>(i), 99, 200, 255}, name});
      glb.json["images"].push_back({{"uri", name}});
      glb.json["textures"].push_back({{"source", i}});
      glb.json["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
    }
    std::filesystem::copy_file(file("p0.png"), file("again.png"));
    glb.json["images"].push_back({{"uri", "again.png"}});
    glb.json["textures"].push_back({{"source", count}});
    glb.json["materials"].push_back({{"emissiveTexture", {{"index", count}}}});
  }
};

TEST_F(ManyPictures, ASecondLoadDecodesNothing) {
  make(12);
  const ImageCounts before = imagePool().counts();
  const Model first = load();
  const ImageCounts between = imagePool().counts();
  EXPECT_EQ(between.decoded - before.decoded, 12u);
  EXPECT_EQ(first.materials[12].emissiveTexture.image, first.materials[0].emissiveTexture.image);
  for (std::uint8_t i = 0; i < 12; ++i) EXPECT_EQ(first.materials[i].emissiveTexture.image->pixels[0], i);
  const Model second = loadModelFile(write("second.glb", glb.glb()));
  EXPECT_EQ(imagePool().counts().decoded, between.decoded);
  EXPECT_EQ(second.materials[7].emissiveTexture.image, first.materials[7].emissiveTexture.image);
}

// A few compressed bytes may be gigabytes of pictures.
TEST_F(ManyPictures, AreRefusedWhereTheMemoryDoesNotAllowThem) {
  make(12);
  const std::uint64_t most = imagePool().mostBytes();
  EXPECT_GT(most, std::uint64_t(1) << 24);
  imagePool().setMostBytes(12 * 4);
  load();
  imagePool().setMostBytes(12 * 4 - 1);
  const std::string text = errorText([this] { load(); });
  imagePool().setMostBytes(most);
  EXPECT_THAT(text, testing::AllOf(testing::HasSubstr("m.glb"), testing::HasSubstr("use smaller pictures")));
  load();
}

TEST_F(ManyPictures, LoadingReportsItsProgressAndCanBeStopped) {
  make(12);
  load();
  double last = 0.0;
  loadModelFile(file("m.glb"), [&last](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    return true;
  });
  EXPECT_GT(last, 0.5);
  // Other threads may decode the last pictures before this one reports again: a later stop is then never asked for.
  for (int stopAt = 1; stopAt <= 3; ++stopAt) {
    int reports = 0;
    std::string stopped;
    try {
      loadModelFile(file("m.glb"), [&](double) { return ++reports < stopAt; });
    } catch (const LoadCancelled& cancelled) {
      stopped = cancelled.what();
    }
    EXPECT_EQ(stopped.find("loading was cancelled") != std::string::npos, reports >= stopAt) << stopped;
    EXPECT_GE(reports, 1);
  }
}

}  // namespace
}  // namespace boxprobe
