// MTL statements and what becomes of them. Right values stand in the input or are computed here.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/io/image/image_file.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class MtlFile : public TemporaryFolder {
 protected:
  MtlFile() {
    write("m.obj",
          "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 3 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 3/3/1\n");
  }
  std::string problem(int libraries) const {
    std::string text = "v 0 0 0\nv 2 0 0\nv 0 3 0\n";
    for (int i = 0; i < libraries; ++i) text += "mtllib m" + std::to_string(i) + ".mtl\n";
    write("many.obj", text + "f 1 2 3\n");
    return errorText([this] { readModel(file("many.obj")); });
  }
  Model model(const std::string& statements) const {
    write("m.mtl", "newmtl m\n" + statements);
    return readModel(file("m.obj"));
  }
  Material material(const std::string& statements) const { return model(statements).materials.at(0); }
  /// Of a single warning.
  std::string warning(const std::string& statements) const {
    const Model loaded = model(statements);
    EXPECT_EQ(loaded.warnings.size(), 1u) << statements;
    return loaded.warnings.empty() ? "" : loaded.warnings[0];
  }
  void picture(const std::string& name, int width, std::vector<std::uint8_t> rgba) const {
    const int height = static_cast<int>(rgba.size()) / 4 / width;
    savePng(file(name), ImageRgba8{width, height, std::move(rgba), name});
  }
  void greyPicture(const std::string& name, int width, const std::vector<int>& values) const {
    std::vector<std::uint8_t> rgba;
    for (const int value : values) {
      const auto byte = static_cast<std::uint8_t>(value);
      rgba.insert(rgba.end(), {byte, byte, byte, 255});
    }
    picture(name, width, std::move(rgba));
  }
};

// Each name that is missing was looked for in the folder.
TEST_F(MtlFile, MoreLibrariesThanAnyModelHasAreRefused) {
  const std::string line = problem(10001);
  EXPECT_NE(line.find("many.obj:10004: more than 10000 lines name material files"), std::string::npos) << line;
}

TEST_F(MtlFile, NumbersOfTheExtensionForPhysicallyBasedMaterials) {
  const Material m =
      material("KD .75 .5 .25\nPr .3\nPm .9\nPs .2\nPc .7\nPcr .1\naniso .6\nanisor .25\nKe .5 4 .125\n");
  EXPECT_EQ(glm::vec3(m.baseColor), glm::vec3(0.75f, 0.5f, 0.25f));
  EXPECT_FLOAT_EQ(m.roughness, 0.3f);
  EXPECT_FLOAT_EQ(m.metallic, 0.9f);
  EXPECT_EQ(m.finish.sheenColor, glm::vec3(0.2f));
  EXPECT_FLOAT_EQ(m.coat, 0.7f);
  EXPECT_FLOAT_EQ(m.coatRoughness, 0.1f);
  EXPECT_FLOAT_EQ(m.finish.anisotropy, 0.6f);
  EXPECT_NEAR(m.finish.anisotropyRotation, 1.570796, 1e-5) << "a quarter of a turn";
  EXPECT_EQ(m.emissive, glm::vec3(0.5f, 4.0f, 0.125f));
  EXPECT_FALSE(model("Pr .3\naniso .6\n").meshes.at(0).tangents.empty());
}

TEST_F(MtlFile, ShininessIsRoughness) {
  for (const double ns : {0.0, 10.0, 900.0}) {
    const Material m = material("Kd .5 .5 .5\nNs " + std::to_string(ns) + "\n");
    const double alpha = static_cast<double>(m.roughness) * static_cast<double>(m.roughness);
    EXPECT_NEAR(2.0 / (alpha * alpha) - 2.0, ns, 1e-3 * (ns + 1.0));  // Walter et al. 2007, the other way round
  }
  EXPECT_FLOAT_EQ(material("Ns 900\nPr .5\n").roughness, 0.5f) << "Pr counts";
}

TEST_F(MtlFile, HighlightsMirrorsAndLambert) {
  EXPECT_FLOAT_EQ(material("Kd .5 .5 .5\nillum 2\n").specular, 1.0f);
  EXPECT_NEAR(material("Kd .5 .5 .5\nKs .5 .5 .5\nillum 2\n").specular, 1.0f, 1e-6f);
  EXPECT_NEAR(material("Kd .5 .5 .5\nKs .25 .25 .25\nillum 2\n").specular, 0.5f, 1e-6f);
  EXPECT_FLOAT_EQ(material("Kd .5 .5 .5\nKs 0 0 0\nillum 2\n").specular, 0.0f);
  EXPECT_FLOAT_EQ(material("Kd .5 .5 .5\nKs 1 1 1\nillum 1\n").specular, 0.0f) << "illum 1 has no highlights";
  EXPECT_TRUE(material("Kd .5 .5 .5\nillum 0\n").unlit);
  const Material mirror = material("Kd 0 0 0\nKs .9 .6 .3\nNs 900\nillum 3\n");
  EXPECT_NEAR(mirror.metallic, 1.0f, 1e-5f);
  EXPECT_LT(glm::distance(glm::vec3(mirror.baseColor), glm::vec3(0.9f, 0.6f, 0.3f)), 1e-5f);
  // The light at normal incidence of both models: specular kS, diffuse kD of what is not reflected.
  const Material half = material("Kd .4 .4 .4\nKs .3 .3 .3\nillum 3\n");
  EXPECT_NEAR(0.04f * (1.0f - half.metallic) + half.baseColor.r * half.metallic, 0.3f, 0.02f);
}

TEST_F(MtlFile, Opacity) {
  EXPECT_EQ(material("Kd 1 0 0\n").alphaMode, AlphaMode::Opaque);
  EXPECT_FLOAT_EQ(material("Kd 1 0 0\nd .4\n").baseColor.a, 0.4f);
  EXPECT_EQ(material("Kd 1 0 0\nd .4\n").alphaMode, AlphaMode::Blend);
  EXPECT_FLOAT_EQ(material("Kd 1 0 0\nTr .3\n").baseColor.a, 0.7f);
  EXPECT_FLOAT_EQ(material("Kd 1 0 0\nd 1\nTr 1\n").baseColor.a, 1.0f) << "d counts";
  EXPECT_NE(warning("Kd 1 0 0\nTr 1\n").find("Tr 1 without d"), std::string::npos);
  const Material glass = material("Kd 0 0 0\nd .25\nNi 1.45\nTf .2 .9 .4\nillum 7\n");
  EXPECT_FLOAT_EQ(glass.transmission, 0.75f);
  EXPECT_FLOAT_EQ(glass.ior, 1.45f);
  EXPECT_FALSE(glass.thin);
  EXPECT_EQ(glass.alphaMode, AlphaMode::Opaque);
  EXPECT_LT(glm::distance(glm::vec3(glass.baseColor), 0.75f * glm::vec3(0.2f, 0.9f, 0.4f)), 1e-6f);
  EXPECT_TRUE(material("Kd 1 1 1\nd .25\nTf 0 1 0\nillum 4\n").thin) << "illum 4 does not refract";
  EXPECT_NE(warning("Kd 1 1 1\nTf 0 1 0\nillum 2\n").find("Tf of what is no glass"), std::string::npos);
}

TEST_F(MtlFile, NamesOfPicturesAsTheyAreWritten) {
  for (const char* name : {"red.png", "my red tile.png", "r\xc3\xb6t \xe6\x9c\xa8.png", "100%red#1.png", "-red.png"}) {
    picture(name, 1, {200, 10, 20, 255});
    for (const std::string& quote : {std::string(), std::string("\"")}) {
      const Model loaded = model("Kd 1 1 1\nmap_Kd " + quote + name + quote + "  \r\n");
      ASSERT_TRUE(loaded.materials.at(0).baseColorTexture.image) << name;
      EXPECT_EQ(loaded.materials[0].baseColorTexture.image->pixels[0], 200) << name;
      EXPECT_TRUE(loaded.warnings.empty()) << name;
    }
  }
  for (const char* name : {"RED.PNG", "C:\\textures\\red.png", "..\\elsewhere\\red.png", "/home/author/red.png"}) {
    EXPECT_TRUE(material("map_kd " + std::string(name) + "\n").baseColorTexture.image) << name;
  }
  EXPECT_EQ(glm::vec3(material("map_Kd red.png\n").baseColor), glm::vec3(1.0f)) << "no Kd: the picture as it is";
  EXPECT_FLOAT_EQ(material("Kd .5 .5 .5\nmap_Kd red.png\n").baseColor.r, 0.5f);
  EXPECT_NE(warning("Kd 0 0 0\nmap_Kd red.png\n").find("Kd 0 beside a picture"), std::string::npos);
  EXPECT_EQ(glm::vec3(material("Kd 0 0 0\nmap_Kd red.png\n").baseColor), glm::vec3(1.0f));
}

TEST_F(MtlFile, OptionsPlaceThePicture) {
  picture("p.png", 1, {200, 10, 20, 255});
  const Material m = material("map_Kd -blendu off -s 2 3 1 -o .25 .5 0 -clamp on -mm 0.1 0.5 p.png\n");
  const TextureUse& use = m.baseColorTexture;
  ASSERT_TRUE(use.image);
  EXPECT_EQ(use.wrapS, Wrap::ClampToEdge);
  // MTL looks up s * (u, v) + o with v upwards; ours has v downwards at both ends.
  const glm::vec2 at(0.3f, 0.9f);
  const glm::vec2 ours = use.uvTransform * glm::vec3(at.x, 1.0f - at.y, 1.0f);
  EXPECT_NEAR(ours.x, 2.0f * at.x + 0.25f, 1e-6f);
  EXPECT_NEAR(1.0f - ours.y, 3.0f * at.y + 0.5f, 1e-6f);
  EXPECT_EQ(use.image->pixels[0], std::lround(0.1 * 255 + 0.5 * 200));
  EXPECT_EQ(use.image->pixels[1], std::lround(0.1 * 255 + 0.5 * 10));
  EXPECT_EQ(material("map_Kd -s 2 p.png\n").baseColorTexture.uvTransform[0][0], 2.0f) << "one number of three";
  EXPECT_NE(warning("map_Kd -boost 2 -t 1 1 1 p.png\n").find("-boost 2, -t (turbulence)"), std::string::npos);
}

TEST_F(MtlFile, RoughnessAndMetalnessArePacked) {
  greyPicture("rough.png", 2, {30, 60, 90, 120});
  greyPicture("metal.png", 1, {255, 0});
  const Material m = material("Kd 1 1 1\nPr 1\nPm 1\nmap_Pr rough.png\nmap_Pm metal.png\n");
  const auto image = m.metallicRoughnessTexture.image;
  ASSERT_TRUE(image);
  ASSERT_EQ(image->width, 2);
  ASSERT_EQ(image->height, 2);
  const int rough[4] = {30, 60, 90, 120}, metal[4] = {255, 255, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(image->pixels[4 * i + 1], rough[i]) << i;
    EXPECT_EQ(image->pixels[4 * i + 2], metal[i]) << i;
  }
  EXPECT_FLOAT_EQ(m.metallic, 1.0f);
  const Material alone = material("Pm .5\nmap_Pr rough.png\n");
  EXPECT_EQ(alone.metallicRoughnessTexture.image->pixels[2], 255) << "metalness is the factor's alone";
  EXPECT_FLOAT_EQ(alone.metallic, 0.5f);
  picture("packed.png", 1, {50, 100, 150, 255});
  const Material orm = material("map_ORM packed.png\n");
  EXPECT_EQ(orm.metallicRoughnessTexture.image->pixels[1], 100);
  EXPECT_EQ(orm.metallicRoughnessTexture.image->pixels[2], 150);
  EXPECT_EQ(orm.occlusionTexture.image->pixels[0], 50);
  EXPECT_EQ(material("map_RMA packed.png\n").metallicRoughnessTexture.image->pixels[1], 50);
  EXPECT_EQ(material("map_Pr -imfchan b packed.png\n").metallicRoughnessTexture.image->pixels[1], 150);
  greyPicture("shine.png", 1, {51});
  const Material shiny = material("Ns 100\nmap_Ns shine.png\n");
  EXPECT_NEAR(shiny.metallicRoughnessTexture.image->pixels[1], 255.0 * std::pow(2.0 / (100.0 * 0.2 + 2.0), 0.25), 0.6);
}

TEST_F(MtlFile, MasksCutOut) {
  picture("red.png", 2, {200, 10, 20, 255, 100, 10, 20, 255});
  greyPicture("mask.png", 2, {255, 0});
  Material m = material("Kd 1 1 1\nmap_Kd red.png\nmap_d mask.png\n");
  EXPECT_EQ(m.alphaMode, AlphaMode::Mask);
  const auto image = m.baseColorTexture.image;
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels, (std::vector<std::uint8_t>{200, 10, 20, 255, 100, 10, 20, 0}));
  m = material("Kd 1 0 0\nmap_d mask.png\n");
  ASSERT_TRUE(m.baseColorTexture.image);
  EXPECT_EQ(m.baseColorTexture.image->pixels, (std::vector<std::uint8_t>{255, 255, 255, 255, 255, 255, 255, 0}));
  EXPECT_EQ(m.baseColor, glm::vec4(1, 0, 0, 1));
  greyPicture("soft.png", 2, {90, 128});
  EXPECT_EQ(material("map_d soft.png\n").alphaMode, AlphaMode::Blend);
  picture("alpha.png", 2, {200, 10, 20, 255, 100, 10, 20, 7});
  EXPECT_EQ(material("map_Kd alpha.png\nmap_d alpha.png\n").baseColorTexture.image->pixels[7], 7) << "its own alpha";
}

TEST_F(MtlFile, NormalsAndHeights) {
  picture("nm.png", 1, {200, 128, 220, 255});
  for (const char* key : {"norm", "map_Bump", "bump", "map_bump"}) {
    const Model loaded = model(std::string(key) + " -bm 0.5 nm.png\n");
    const Material& m = loaded.materials.at(0);
    ASSERT_TRUE(m.normalTexture.image) << key;
    EXPECT_EQ(m.normalTexture.image->pixels[0], 200) << key;
    EXPECT_FLOAT_EQ(m.normalScale, 0.5f) << key;
    EXPECT_FALSE(loaded.meshes.at(0).tangents.empty()) << "normal maps need tangents";
  }
  // Almost all of a usual normal map points straight out: red and green are alike there, and blue is not.
  const std::vector<std::uint8_t> flat = {128, 128, 255, 255, 133, 129, 250, 255};
  picture("flat.png", 2, flat);
  EXPECT_EQ(material("bump flat.png\n").normalTexture.image->pixels, flat);
  // A slope that rises by 20 of 255 from texel to texel, to the right; the row below is 10 higher.
  greyPicture("height.png", 4, {0, 20, 40, 60, 10, 30, 50, 70, 20, 40, 60, 80, 30, 50, 70, 90});
  const Material m = material("bump -bm 2 height.png\n");
  ASSERT_TRUE(m.normalTexture.image);
  const std::uint8_t* texel = m.normalTexture.image->pixels.data() + 4 * (1 * 4 + 1);
  const glm::vec3 n = glm::vec3(texel[0], texel[1], texel[2]) / 127.5f - 1.0f;
  const glm::vec2 scaled = m.normalScale * glm::vec2(n) / n.z;
  EXPECT_NEAR(scaled.x, -2.0f * 20.0f / 255.0f, 4e-3f) << "leans away from what rises to the right";
  EXPECT_NEAR(scaled.y, 2.0f * 10.0f / 255.0f, 4e-3f) << "up, away from what rises downwards";
}

TEST_F(MtlFile, OtherPictures) {
  picture("p.png", 1, {200, 10, 20, 255});
  EXPECT_TRUE(material("map_Ke p.png\n").emissiveTexture.image);
  EXPECT_EQ(material("map_Ke p.png\n").emissive, glm::vec3(1.0f));
  EXPECT_EQ(material("Ke 2 2 2\nmap_Ke p.png\n").emissive, glm::vec3(2.0f));
  EXPECT_TRUE(material("Ks 1 1 1\nmap_Ks p.png\nillum 2\n").finish.specularColorTexture.image);
  EXPECT_TRUE(material("Pc 1\nmap_Pc p.png\n").coatTexture.image);
  EXPECT_TRUE(material("Pc 1\nmap_Pcr p.png\n").coatRoughnessTexture.image);
  EXPECT_TRUE(material("Ps 1\nmap_Ps p.png\n").finish.sheenColorTexture.image);
}

TEST_F(MtlFile, WhatIsLeftOutIsSaidOnce) {
  EXPECT_EQ(warning("Kd 1 1 1\ndisp d.png\nrefl -type sphere r.png\nsharpness 60\nKm 1\ndisp d.png\n"),
            "has statements in m.mtl that are not used as written: Km, disp, refl, sharpness");
  EXPECT_NE(warning("Kd 1 1 1\nKa .3 .1 0\n").find("as written: Ka"), std::string::npos);
  EXPECT_TRUE(model("Kd 1 1 1\nKa 1 1 1\nKs .5 .5 .5\nNi 1.5\nd 1\nTf 1 1 1\nillum 2\n").warnings.empty());
  EXPECT_EQ(warning("Kd 1 x 1\n"), "m.mtl:2: \"x\" is not a number; this Kd is left out");
  write("broken.jpg", "no picture");
  const Model broken = model("Kd 1 0 0\nmap_Kd broken.jpg\nnorm gone.png\n");
  ASSERT_EQ(broken.warnings.size(), 2u);
  EXPECT_EQ(broken.warnings[0], "has the texture gone.png, which does not exist; it is left out");
  EXPECT_EQ(broken.warnings[1].rfind("broken.jpg: is not a PNG, JPEG or WebP picture", 0), 0u);
  EXPECT_NEAR(broken.materials.at(0).baseColor.r, 0.2159f, 1e-4f) << "sRGB's middle grey";
}

}  // namespace
}  // namespace boxprobe
