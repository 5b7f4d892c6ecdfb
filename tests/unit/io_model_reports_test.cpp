// Model files that people reported to other programs, written here in a few bytes. The table with links and verdicts is
// tests/README.md#public-reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "filters/io/image/image_file.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Reports : public TemporaryFolder {
 protected:
  Model load(const std::string& name, const std::string& bytes) const { return readModel(write(name, bytes)); }

  /// The area of everything with this base colour, and where its middle is: the sum over triangles, in world space.
  struct Extent {
    double area = 0.0;
    glm::dvec3 middle{0.0};
  };
  static Extent extentOf(const Model& model, const glm::vec3& color) {
    Extent extent;
    for (const Instance& instance : model.instances) {
      const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
      if (glm::distance(glm::vec3(model.materials.at(static_cast<std::size_t>(mesh.material)).baseColor), color) >
          0.01f)
        continue;
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        glm::dvec3 corners[3];
        for (std::size_t k = 0; k < 3; ++k) {
          corners[k] =
              glm::dvec3(instance.worldFromModel * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
        }
        const double area = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        extent.area += area;
        extent.middle += area / 3.0 * (corners[0] + corners[1] + corners[2]);
      }
    }
    if (extent.area > 0.0) extent.middle /= extent.area;
    return extent;
  }
  static void expectExtent(const Extent& extent, double area, const glm::dvec3& middle) {
    EXPECT_NEAR(extent.area, area, 1e-5);
    EXPECT_LT(glm::distance(extent.middle, middle), 1e-5);
  }

  /// A quad from (0, 0) to (2, 3), whose lines end as said; the body has `points` (text, or 12 bytes each) and a face.
  static std::string plyHeader(const std::string& format, const std::string& end, const std::string& more = "") {
    const std::string lines = "ply\nformat " + format + " 1.0\n" + more +
                              "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n";
    std::string header;
    for (const char c : lines) header += c == '\n' ? end : std::string(1, c);
    return header;
  }
  static std::string binaryBody() {
    const float points[12] = {0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0};
    const std::int32_t corners[4] = {0, 1, 2, 3};
    std::string bytes(reinterpret_cast<const char*>(points), sizeof points);
    bytes += '\4';
    return bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
  }
  void expectQuad(const Model& model) const {
    ASSERT_EQ(model.triangleCount(), 2u);
    expectExtent(extentOf(model, glm::vec3(model.materials.at(0).baseColor)), 6.0, {1.0, 1.5, 0.0});
  }
};

const char* const kTwoColors = "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n";

// trimesh 2364: vertices stand between faces, and negative indices count from where the face stands.
TEST_F(Reports, NegativeIndicesAmongVertices) {
  write("m.mtl", kTwoColors);
  const std::string at0 = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\n", at10 = "v 10 0 0\nv 11 0 0\nv 11 3 0\nv 10 3 0\n",
                    at20 = "v 20 0 0\nv 24 0 0\nv 20 3 0\n";
  const Model model = load("m.obj", "mtllib m.mtl\no a\nusemtl red\n" + at0 + "f -4 -3 -2 -1\no b\nusemtl green\n" +
                                        at10 + "f -4 -3 -2 -1\no c\nusemtl red\n" + at20 + "f -3 -2 -1\n");
  EXPECT_EQ(model.instances.size(), 3u);
  // Red: a rectangle of 6 and a triangle of 6; green: a rectangle of 3.
  expectExtent(extentOf(model, {1, 0, 0}), 12.0, glm::dvec3(1.0 + 64.0 / 3.0, 1.5 + 1.0, 0.0) / 2.0);
  expectExtent(extentOf(model, {0, 1, 0}), 3.0, {10.5, 1.5, 0.0});
}

// f3d 2320: positions and normals count back each by themselves.
TEST_F(Reports, NegativeNormalsOfTheirOwnCount) {
  const Model model =
      load("m.obj", "vn 1 0 0\nvn 0 0 1\nvn 0 1 0\nv 9 9 9\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf -3//-2 -2//-3 -1//-1\n");
  ASSERT_EQ(model.triangleCount(), 1u);
  const Mesh& mesh = model.meshes[0];
  const auto normalAt = [&](const glm::vec3& position) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (mesh.positions[i] == position) return mesh.normals[i];
    }
    return glm::vec3(0.0f);
  };
  EXPECT_EQ(normalAt({0, 0, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(normalAt({2, 0, 0}), glm::vec3(1, 0, 0));
  EXPECT_EQ(normalAt({0, 3, 0}), glm::vec3(0, 1, 0));
}

// ufbx 213: Blender 4.4 writes "usemtl" without a name for faces without a material.
TEST_F(Reports, AMaterialWithoutAName) {
  write("m.mtl", kTwoColors);
  const std::string points = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\n";
  const Model model = load("m.obj", "mtllib m.mtl\n" + points + "usemtl green\nf 1 2 3\nusemtl\nf 1 3 4\n");
  EXPECT_EQ(model.triangleCount(), 2u);
  expectExtent(extentOf(model, {0, 1, 0}), 3.0, {4.0 / 3.0, 1.0, 0.0});
}

// openMVS 1285: "Tr 1" by a program that means opaque, and map_Kd without a picture. tinyobjloader 43: d and Tr at
// once.
TEST_F(Reports, OpaqueMaterialsOfTwoDialects) {
  for (const char* lines : {"Tr 1.000000\nillum 1\nNs 1\nmap_Kd\n", "d 1.0\nTr 0.0\n", "Tr 0.0\nd 1.0\n"}) {
    write("m.mtl", std::string("newmtl red\nKd 1 0 0\n") + lines);
    const Model model = load("m.obj", "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n");
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].baseColor, glm::vec4(1, 0, 0, 1)) << lines;
    EXPECT_EQ(model.materials[0].alphaMode, AlphaMode::Opaque) << lines;
  }
}

// threejs-full-es6 16: some faces have texture coordinates, others none.
TEST_F(Reports, TextureCoordinatesOfSomeFaces) {
  savePng(file("t.png"), ImageRgba8{1, 1, {9, 200, 9, 255}, "t"});
  write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl pictured\nmap_Kd t.png\n");
  const Model model =
      load("m.obj",
           "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 3 0\nv 10 0 0\nv 11 0 0\nv 10 1 0\nvt .25 .5\nvt .75 .5\n"
           "vt .25 1\nusemtl red\nf 1 2 3\nusemtl pictured\nf 4/1 5/2 6/3\n");
  expectExtent(extentOf(model, {1, 0, 0}), 3.0, {2.0 / 3.0, 1.0, 0.0});
  int pictured = 0;
  for (const Mesh& mesh : model.meshes) {
    if (!model.materials.at(static_cast<std::size_t>(mesh.material)).baseColorTexture.image) continue;
    ++pictured;
    ASSERT_EQ(mesh.uv.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
      EXPECT_NEAR(mesh.uv[i].x, 0.25f + 0.5f * (mesh.positions[i].x - 10.0f), 1e-6f);
      EXPECT_NEAR(mesh.uv[i].y, 0.5f - 0.5f * mesh.positions[i].y, 1e-6f);  // downwards
    }
  }
  EXPECT_EQ(pictured, 1);
}

// AssetStudio 73 and meshlab 372: numbers in the language of the author's computer.
TEST_F(Reports, DecimalCommas) {
  const Model obj = load("m.obj", "v 0,5 0 -0,25\nv 2,5 0 -0,25\nv 0,5 3,0 -0,25\nf 1 2 3\n");
  expectExtent(extentOf(obj, glm::vec3(obj.materials.at(0).baseColor)), 3.0, {0.5 + 2.0 / 3.0, 1.0, -0.25});
  EXPECT_THAT(obj.warnings, ElementsAre("has decimal commas, which are read as points"));
  const Model stl =
      load("m.stl",
           "solid STL generated by MeshLab\n  facet normal -0,000000e+00  0,000000e+00 -1,000000e+00\n"
           "    outer loop\n      vertex  5,000000e-01 0,000000e+00 -2,500000e-01\n      vertex  2,5e0 0,0 -0,25\n"
           "      vertex 0,5 3,0 -0,25\n    endloop\n  endfacet\nendsolid vcg\n");
  expectExtent(extentOf(stl, glm::vec3(stl.materials.at(0).baseColor)), 3.0, {0.5 + 2.0 / 3.0, 1.0, -0.25});
}

// three.js 15099 and 26232, Open3D 5091: a header whose lines end in two bytes, in either order, before binary data.
TEST_F(Reports, BinaryPlyBehindEveryKindOfLineEnd) {
  for (const char* end : {"\n", "\r\n", "\n\r", "\r"}) {
    SCOPED_TRACE(::testing::PrintToString(end));
    expectQuad(load("m.ply", plyHeader("binary_little_endian", end) + binaryBody()));
  }
}

// happly 45: empty lines between header and body. assimp 819: an empty comment. spark 338: obj_info.
TEST_F(Reports, PlyWithEmptyLinesAndComments) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    SCOPED_TRACE(::testing::PrintToString(end));
    const std::string body = std::string(end) + "0 0 0" + end + end + "2 0 0" + end + "2 3 0" + end + " " + end +
                             "0 3 0" + end + "4 0 1 2 3" + end + end;
    expectQuad(load("m.ply", plyHeader("ascii", end, "comment\nobj_info\nobj_info num_cols 4\n") + body));
  }
}

// assimp 3759: coordinates of vertices and of corners at once, as MeshLab writes them, and a picture.
TEST_F(Reports, PlyWithTwoKindsOfCoordinates) {
  savePng(file("t.png"), ImageRgba8{1, 1, {200, 9, 9, 255}, "t"});
  const Model model = load(
      "m.ply",
      "ply\nformat ascii 1.0\ncomment VCGLIB generated\ncomment TextureFile t.png\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float texture_u\nproperty float texture_v\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "0 0 0 .25 .5\n2 0 0 .75 .5\n0 3 0 .25 1\n3 0 1 2 6 .25 .5 .75 .5 .25 1\n");
  ASSERT_EQ(model.meshes.size(), 1u);
  ASSERT_TRUE(model.materials.at(0).baseColorTexture.image);
  EXPECT_EQ(model.materials[0].baseColorTexture.image->pixels[0], 200);
  for (std::size_t i = 0; i < model.meshes[0].uv.size(); ++i) {
    EXPECT_NEAR(model.meshes[0].uv[i].x, 0.25f + 0.25f * model.meshes[0].positions[i].x, 1e-6f);
    EXPECT_NEAR(model.meshes[0].uv[i].y, 0.5f - model.meshes[0].positions[i].y / 6.0f, 1e-6f);
  }
}

// meshlab 1281: a binary STL whose number of triangles was never written.
TEST_F(Reports, StlWithoutItsCount) {
  std::string bytes(84, '\0');
  bytes.replace(0, 9, "ZanderCAD");
  for (const float x : {0.0f, 10.0f}) {
    const float triangle[12] = {0, 0, 1, x, 0, 0, x + 2, 0, 0, x, 3, 0};
    bytes.append(reinterpret_cast<const char*>(triangle), 48);
    bytes.append(2, '\0');
  }
  const Model model = load("m.stl", bytes);
  expectExtent(extentOf(model, glm::vec3(model.materials.at(0).baseColor)), 6.0, {5.0 + 2.0 / 3.0, 1.0, 0.0});
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_THAT(model.warnings[0], HasSubstr("promises 0 triangles and holds 2"));
}

TEST_F(Reports, StlTextWithAByteOrderMark) {
  const Model model =
      load("m.stl",
           "\xef\xbb\xbfsolid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 0\n"
           "endloop\nendfacet\nendsolid a\n");
  expectExtent(extentOf(model, glm::vec3(model.materials.at(0).baseColor)), 3.0, {2.0 / 3.0, 1.0, 0.0});
}

/// A triangle of one colour in this type.
template <typename Number>
std::string coloredGlb(GlbBuilder::Component type, const std::vector<Number>& color, bool marked) {
  GlbBuilder glb;
  std::vector<Number> values;
  for (int i = 0; i < 3; ++i) values.insert(values.end(), color.begin(), color.end());
  const int colors = glb.accessor(glb.view(values), type, "VEC4", 3);
  if (marked) glb.json["accessors"][static_cast<std::size_t>(colors)]["normalized"] = true;
  glb.triangle({{"attributes", {{"COLOR_0", colors}}}});
  return glb.glb();
}

std::vector<glm::vec4> colorsOf(const Model& model, std::vector<std::string>& warnings) {
  warnings = model.warnings;
  return model.meshes.at(0).colors;
}

// Godot 44798: vertex colours of 16 bits that are not marked as normalized.
TEST_F(Reports, ColoursInWholeNumbers) {
  const std::vector<std::uint16_t> words = {65535, 16384, 8192, 65535};
  const std::vector<std::uint8_t> bytes = {255, 64, 32, 255};
  std::vector<std::string> warnings;
  for (const bool marked : {false, true}) {
    for (const glm::vec4& color : colorsOf(load("m.glb", coloredGlb(GlbBuilder::UShort, words, marked)), warnings)) {
      EXPECT_LT(glm::distance(color, glm::vec4(1.0f, 16384 / 65535.0f, 8192 / 65535.0f, 1.0f)), 1e-6f) << marked;
    }
    EXPECT_EQ(warnings.size(), marked ? 0u : 1u);
    for (const glm::vec4& color : colorsOf(load("m.glb", coloredGlb(GlbBuilder::UByte, bytes, marked)), warnings)) {
      EXPECT_LT(glm::distance(color, glm::vec4(1.0f, 64 / 255.0f, 32 / 255.0f, 1.0f)), 1e-6f) << marked;
    }
  }
}

}  // namespace
}  // namespace boxprobe
