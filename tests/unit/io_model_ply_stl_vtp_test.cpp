// Colours, coordinates and pictures of PLY, STL and VTP files; what is not drawn is said.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "filters/io/image/image_file.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

/// IEC 61966-2-1.
double linear(double shown) {
  return std::pow((shown + 0.055) / 1.055, 2.4);
}

class MeshFormats : public TemporaryFolder {
 protected:
  Model load(const std::string& name, const std::string& bytes) const { return readModel(write(name, bytes)); }

  /// A quad from (0, 0) to (2, 3): properties of vertices, a row of each, and what faces have.
  static std::string ply(const std::string& properties, const std::vector<std::string>& rows,
                         const std::string& comment = "", const std::string& face = "4 0 1 2 3",
                         const std::string& faceProperties = "") {
    const char* points[4] = {"0 0 0 ", "2 0 0 ", "2 3 0 ", "0 3 0 "};
    std::string text = "ply\nformat ascii 1.0\n" + comment +
                       "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + properties +
                       "element face 1\nproperty list uchar int vertex_indices\n" + faceProperties + "end_header\n";
    for (std::size_t i = 0; i < 4; ++i) text += points[i] + rows[i % rows.size()] + "\n";
    return text + face + "\n";
  }
  /// Every vertex is white times this colour, and the base colour darkens nothing.
  static void expectColor(const Model& model, double red, double green, double blue) {
    ASSERT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.meshes[0].colors.size(), model.meshes[0].positions.size());
    EXPECT_EQ(model.materials.at(0).baseColor, glm::vec4(1.0f));
    for (const glm::vec4& color : model.meshes[0].colors) {
      EXPECT_NEAR(color.r, linear(red), 1e-5);
      EXPECT_NEAR(color.g, linear(green), 1e-5);
      EXPECT_NEAR(color.b, linear(blue), 1e-5);
    }
  }
  /// v = 0 at the top: the corner (2, 3) has (1, 0).
  static void expectPictured(const Model& model) {
    ASSERT_EQ(model.meshes.size(), 1u);
    const Mesh& mesh = model.meshes[0];
    ASSERT_EQ(mesh.uv.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
      EXPECT_NEAR(mesh.uv[i].x, mesh.positions[i].x / 2.0f, 1e-6f);
      EXPECT_NEAR(mesh.uv[i].y, 1.0f - mesh.positions[i].y / 3.0f, 1e-6f);
    }
    const auto image = model.materials.at(0).baseColorTexture.image;
    ASSERT_TRUE(image);
    EXPECT_EQ(image->pixels[0], 200);
    EXPECT_EQ(model.materials[0].baseColor, glm::vec4(1.0f));
    EXPECT_TRUE(model.warnings.empty());
  }

  static std::string stl(const std::string& header, const std::vector<std::uint16_t>& attributes,
                         const std::string& after = "") {
    std::string bytes = header;
    bytes.resize(80, '\0');
    const auto count = static_cast<std::uint32_t>(attributes.size());
    bytes.append(reinterpret_cast<const char*>(&count), 4);
    for (const std::uint16_t attribute : attributes) {
      const float triangle[12] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0};
      bytes.append(reinterpret_cast<const char*>(triangle), 48);
      bytes.append(reinterpret_cast<const char*>(&attribute), 2);
    }
    return bytes + after;
  }

  static std::string vtp(const std::string& pointData, const std::string& cellData = "",
                         const std::string& cells = "") {
    return R"(<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="4" )" +
           cells + R"(NumberOfPolys="2"><PointData>)" + pointData + "</PointData><CellData>" + cellData +
           R"(</CellData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">)"
           R"(0 0 0 2 0 0 2 3 0 0 3 0</DataArray></Points>)"
           R"(<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 0 2 3</DataArray>)"
           R"(<DataArray type="Int32" Name="offsets" format="ascii">3 6</DataArray></Polys></Piece></PolyData></VTKFile>)";
  }
  static std::string array(const std::string& type, const std::string& name, int components,
                           const std::string& numbers) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"ascii\">" + numbers + "</DataArray>";
  }
};

TEST_F(MeshFormats, PlyColoursKeepTheirValue) {
  for (const char* names : {"red green blue", "diffuse_red diffuse_green diffuse_blue", "r g b"}) {
    std::string r, g, b;
    std::istringstream(names) >> r >> g >> b;
    const auto properties = [&](const std::string& type) {
      return "property " + type + " " + r + "\nproperty " + type + " " + g + "\nproperty " + type + " " + b + "\n";
    };
    expectColor(load("m.ply", ply(properties("uchar"), {"188 99 50"})), 188 / 255.0, 99 / 255.0, 50 / 255.0);
    expectColor(load("m.ply", ply(properties("float"), {".7372549 .388 .196"})), 0.7372549, 0.388, 0.196);
    expectColor(load("m.ply", ply(properties("ushort"), {"48316 25443 12850"})), 48316 / 65535.0, 25443 / 65535.0,
                12850 / 65535.0);
  }
  const std::string rgba = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  Model model = load("m.ply", ply(rgba, {"188 99 50 0"}));
  expectColor(model, 188 / 255.0, 99 / 255.0, 50 / 255.0);
  EXPECT_EQ(model.materials[0].alphaMode, AlphaMode::Opaque) << "nobody means an invisible model";
  EXPECT_EQ(model.warnings.size(), 1u);
  model = load("m.ply", ply(rgba, {"188 99 50 51"}));
  EXPECT_EQ(model.materials.at(0).alphaMode, AlphaMode::Blend);
  EXPECT_NEAR(model.meshes.at(0).colors.at(0).a, 0.2f, 1e-6f);
  const std::string face = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  expectColor(load("m.ply", ply("", {""}, "", "4 0 1 2 3 188 99 50", face)), 188 / 255.0, 99 / 255.0, 50 / 255.0);
}

TEST_F(MeshFormats, PlyPictures) {
  savePng(file("a b.png"), ImageRgba8{1, 1, {200, 10, 20, 255}, "p"});
  const std::string comment = "comment TextureFile a b.png\n";
  for (const char* names : {"s t", "u v", "texture_u texture_v"}) {
    std::string u, v;
    std::istringstream(names) >> u >> v;
    expectPictured(load(
        "m.ply", ply("property float " + u + "\nproperty float " + v + "\n", {"0 0", "1 0", "1 1", "0 1"}, comment)));
  }
  expectPictured(
      load("m.ply", ply("", {""}, comment, "4 0 1 2 3 8 0 0 1 0 1 1 0 1", "property list uchar float texcoord\n")));
  const Model gone =
      load("m.ply", ply("property float s\nproperty float t\n", {"0 0"}, "comment TextureFile gone.png\n"));
  ASSERT_EQ(gone.warnings.size(), 1u);
  EXPECT_EQ(gone.warnings[0], "has the texture gone.png, which does not exist; grey takes its place");
  // Two pictures, chosen by face.
  savePng(file("second.png"), ImageRgba8{1, 1, {9, 10, 20, 255}, "q"});
  std::string two =
      ply("", {""}, comment + "comment TextureFile second.png\n", "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 1 0 1 0",
          "property list uchar float texcoord\nproperty int texnumber\n");
  two.replace(two.find("element face 1"), 14, "element face 2");
  const Model both = load("m.ply", two);
  ASSERT_EQ(both.meshes.size(), 2u);
  EXPECT_EQ(both.materials.at(0).baseColorTexture.image->pixels[0], 200);
  EXPECT_EQ(both.materials.at(1).baseColorTexture.image->pixels[0], 9);
  EXPECT_EQ(both.meshes[1].positions.at(0), glm::vec3(0, 0, 0));
  EXPECT_EQ(both.meshes[1].positions.at(1), glm::vec3(2, 0, 0));
}

TEST_F(MeshFormats, PlySaysWhatItDoesNotDraw) {
  const Model model = load("m.ply", ply("property float quality\n", {"1"}, "", "4 0 1 2 3 7", "property int flags\n"));
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(model.warnings[0], "has data that is not drawn: face flags, vertex quality");
}

TEST_F(MeshFormats, StlThatSaysSolidAndHasBytesBehind) {
  for (const std::string& header : {std::string("solid facet normal"), std::string("solid x facet")}) {
    for (const std::string& after : {std::string(), std::string(2, '\0'), std::string(300, '\0')}) {
      EXPECT_EQ(load("m.stl", stl(header, {0, 0}, after)).triangleCount(), 2u) << header << " " << after.size();
    }
  }
}

TEST_F(MeshFormats, StlColours) {
  // Red 31, green 16, blue 4 in each program's order.
  const unsigned viscam = 0x8000u | (31u << 10) | (16u << 5) | 4u, magics = 31u | (16u << 5) | (4u << 10);
  Model model = load("m.stl", stl("exported", {static_cast<std::uint16_t>(viscam)}));
  expectColor(model, 1.0, 16 / 31.0, 4 / 31.0);
  std::string header = "COLOR=";
  header += {'\xbc', '\x63', '\x32', '\xff'};
  expectColor(load("m.stl", stl(header, {static_cast<std::uint16_t>(magics)})), 1.0, 16 / 31.0, 4 / 31.0);
  expectColor(load("m.stl", stl(header, {0x8000})), 188 / 255.0, 99 / 255.0, 50 / 255.0);
  model = load("m.stl", stl("exported", {0, 0}));
  EXPECT_TRUE(model.meshes.at(0).colors.empty());
  EXPECT_FLOAT_EQ(model.materials.at(0).baseColor.r, 0.8f);
  model = load("m.stl", stl("exported", {0, static_cast<std::uint16_t>(viscam)}));
  EXPECT_FLOAT_EQ(model.meshes.at(0).colors.at(0).r, 0.8f) << "a triangle without a colour is as grey as ever";
  EXPECT_EQ(load("m.stl", stl("exported", {7})).warnings.size(), 1u) << "attributes of another meaning";
}

TEST_F(MeshFormats, VtpColoursNormalsAndCoordinates) {
  expectColor(load("m.vtp", vtp(array("UInt8", "RGB", 3, "188 99 50 188 99 50 188 99 50 188 99 50"))), 188 / 255.0,
              99 / 255.0, 50 / 255.0);
  const std::string share = ".7372549 .388 .196 ";
  expectColor(load("m.vtp", vtp(array("Float32", "Colors", 3, share + share + share + share))), 0.7372549, 0.388,
              0.196);
  // A colour for each cell: the line's is the first.
  const Model cells =
      load("m.vtp", vtp("", array("UInt8", "cells", 3, "1 1 1 255 0 0 188 99 50"), "NumberOfLines=\"1\" "));
  ASSERT_EQ(cells.meshes.size(), 1u);
  const Mesh& mesh = cells.meshes[0];
  EXPECT_EQ(glm::vec3(mesh.colors.at(mesh.indices.at(0))), glm::vec3(1, 0, 0));
  EXPECT_NEAR(mesh.colors.at(mesh.indices.at(3)).r, linear(188 / 255.0), 1e-5);
  ASSERT_EQ(cells.warnings.size(), 1u);
  EXPECT_EQ(cells.warnings[0], "has data that is not drawn: lines");
  const Model rich = load(
      "m.vtp", vtp(array("Float32", "Normals", 3, "0 0 -2 0 0 -2 0 0 -2 0 0 -2") +
                   array("Float32", "TCoords", 2, "0 0 1 0 1 1 0 1") + array("Float64", "pressure", 1, "1 2 3 4")));
  EXPECT_EQ(rich.meshes.at(0).normals.at(0), glm::vec3(0, 0, -1));
  EXPECT_EQ(rich.meshes[0].uv.at(2), glm::vec2(1, 0));
  ASSERT_EQ(rich.warnings.size(), 1u);
  EXPECT_EQ(rich.warnings[0], "has data that is not drawn: point array pressure");
}

}  // namespace
}  // namespace boxprobe
