// OBJ with MTL, PLY, STL and VTP: values, missing normals, units and up axis; and files that are
// broken on purpose, each refused in one line.
#include "filters/vtk/import/model_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "filters/core/geometry/model_placement.h"
#include "filters/io/image/image_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class ModelReader : public TemporaryFolder {
 protected:
  Model read(const std::string& name, const std::string& bytes) const { return readModel(write(name, bytes)); }
  void expectRefused(const std::string& name, const std::string& bytes, const std::string& mentioned) const {
    const std::string path = write(name, bytes);
    const std::string text = errorText([&] { readModel(path); });
    EXPECT_EQ(text.rfind(folder_.string(), 0), 0u) << text;
    EXPECT_NE(text.find(mentioned), std::string::npos) << text;
  }
  static std::string binaryStl(std::uint32_t promised, int triangles) {
    std::string bytes(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&promised), 4);
    const float triangle[12] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0};
    for (int i = 0; i < triangles; ++i) {
      bytes.append(reinterpret_cast<const char*>(triangle), 48);
      bytes.append(2, '\0');
    }
    return bytes;
  }
  static constexpr const char* kPly =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 0 0 188\n4 0 1 2 3\n";
};

TEST_F(ModelReader, PointersOfGitLfsAreNamed) {
  for (const char* name : {"m.glb", "m.gltf", "m.obj", "m.ply", "m.stl", "m.vtp"}) {
    expectRefused(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 7\n",
                  ": is a pointer of Git LFS, not the model; fetch it: git lfs pull");
  }
}

TEST_F(ModelReader, ObjHasMaterialsTexturesAndNormals) {
  savePng(file("two.png"), ImageRgba8{1, 2, {255, 0, 0, 255, 0, 0, 255, 255}, "two"});  // red above blue
  write("m.mtl", "newmtl clay\nKd 0.25 0.5 0.75\nNs 30\nnewmtl glass\nKd 1 1 1\nd 0.4\nmap_Kd two.png\n");
  const Model model = read("m.obj",
                           "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "usemtl clay\nf 1/1 2/2 3/3\nusemtl glass\nf 1/1 3/3 4/4\n");
  ASSERT_EQ(model.meshes.size(), 2u);
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.materials[0].name, "clay");
  EXPECT_NEAR(model.materials[0].baseColor.b, 0.75f, 1e-6f);
  EXPECT_NEAR(model.materials[0].roughness, std::pow(2.0 / 32.0, 0.25), 1e-5);
  EXPECT_EQ(model.materials[0].alphaMode, AlphaMode::Opaque);
  EXPECT_EQ(model.materials[1].name, "glass");
  EXPECT_EQ(model.materials[1].alphaMode, AlphaMode::Blend);
  EXPECT_NEAR(model.materials[1].baseColor.a, 0.4f, 1e-6f);
  const auto image = model.materials[1].baseColorTexture.image;
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels[0], 255) << "the first row is the picture's top";
  EXPECT_EQ(image->pixels[4], 0);
  for (const Mesh& mesh : model.meshes) {
    ASSERT_EQ(mesh.indices.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.normals[mesh.indices[i]], glm::vec3(0, 0, 1));
      // Upright: v = 0 at the top, where y is 1.
      EXPECT_NEAR(mesh.uv[mesh.indices[i]].y, 1.0f - mesh.positions[mesh.indices[i]].y, 1e-6f);
    }
  }
}

// What is missing beside an OBJ file costs the colour, not the shape, and is said.
TEST_F(ModelReader, ObjWithoutItsMaterialsIsGrey) {
  const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n";
  const Model gone = read("m.obj", "mtllib gone.mtl\n" + quad + "usemtl clay\nf 1 2 3\nusemtl oak\nf 1 3 4\n");
  ASSERT_EQ(gone.warnings.size(), 1u);
  EXPECT_EQ(gone.warnings[0], "has the material file gone.mtl, which does not exist; grey takes its place");
  ASSERT_EQ(gone.materials.size(), 2u);
  EXPECT_EQ(gone.materials[1].name, "oak");
  EXPECT_NEAR(gone.materials[0].baseColor.g, 0.8f, 1e-6f);

  write("q.mtl", "newmtl a\nKd 0 0 0\nmap_Kd gone.png\nnewmtl b\nKd 1 0 0\nmap_Kd text.png\n");
  write("text.png", "no picture");
  const Model plain =
      read("m.obj", "mtllib q.mtl\n" + quad + "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1 2 3\nusemtl c\nf 1 3 4\n");
  ASSERT_EQ(plain.warnings.size(), 3u);
  EXPECT_NE(plain.warnings[0].find("material c, which its material file does not define"), std::string::npos);
  EXPECT_EQ(plain.warnings[1], "has the texture gone.png, which does not exist; grey takes its place");
  EXPECT_NE(plain.warnings[2].find("text.png"), std::string::npos);
  ASSERT_EQ(plain.materials.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(plain.materials[i].baseColor.r, 0.2159f, 1e-4f) << i;

  std::filesystem::create_directory(folder_ / "tex");
  savePng(file("tex/red.png"), ImageRgba8{1, 1, {255, 0, 0, 255}, "red"});
  write("tex/w.mtl", "newmtl a\nmap_Kd red.png\n");
  const Model windows = read("m.obj", "mtllib tex\\w.mtl\n" + quad + "usemtl a\nf 1/1 2/1 3/1\n");
  EXPECT_TRUE(windows.warnings.empty());
  ASSERT_TRUE(windows.materials.at(0).baseColorTexture.image);
  EXPECT_EQ(windows.materials[0].baseColorTexture.image->pixels[0], 255);
}

TEST_F(ModelReader, ObjMaterialNamesMayHaveSpaces) {
  write("s.mtl", "newmtl hard shiny plastic\nKd 0.25 0 0\nTf 1 1 1\n");
  const Model model = read("m.obj",
                           "mtllib s.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl hard shiny plastic\n"
                           "f 1 2 3\nusemtl\nf 2 4 3\n");
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.materials[0].name, "hard shiny plastic");
  EXPECT_NEAR(model.materials[0].baseColor.r, 0.25f, 1e-6f);
  EXPECT_NEAR(model.materials[1].baseColor.r, 0.8f, 1e-6f);
}

TEST_F(ModelReader, ObjVertexColors) {
  const Model model = read("m.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  const Mesh& mesh = model.meshes.at(0);
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].x == 1.0f) {
      EXPECT_NEAR(mesh.colors[i].g, 0.2140f, 1e-3f) << "sRGB decoded";
    }
    if (mesh.positions[i].y == 1.0f) {
      EXPECT_EQ(mesh.colors[i], glm::vec4(0, 0, 1, 1));
    }
  }
}

TEST_F(ModelReader, PlyFloatColorsAndStrips) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\n";
  const std::string vertices = "0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 0 0 0.5\n1 1 0 1 0 0\n";
  for (const bool strips : {false, true}) {
    const Model model = read("m.ply", head + (strips ? "element tristrips 1\n" : "element face 2\n") +
                                          "property list int int vertex_indices\nend_header\n" + vertices +
                                          (strips ? "6 0 1 2 3 -1 0\n" : "3 0 1 2\n3 1 3 2\n"));
    ASSERT_EQ(model.triangleCount(), 2u) << strips;
    const Mesh& mesh = model.meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const bool blue = mesh.positions[i] == glm::vec3(0, 1, 0);
      EXPECT_NEAR(mesh.colors[i].r, blue ? 0.0f : 1.0f, 1e-6f);
      EXPECT_NEAR(mesh.colors[i].b, blue ? 0.2158f : 0.0f, 2e-3f) << "sRGB decoded";
      EXPECT_EQ(mesh.normals[i], glm::vec3(0, 0, 1)) << "every triangle the same way round";
    }
  }
  expectRefused(
      "m.ply",
      head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + vertices + "3 0 1 9\n",
      "corner 9");
}

TEST_F(ModelReader, PlyHasVertexColorsAndPolygons) {
  const Model model = read("m.ply", kPly);
  ASSERT_EQ(model.triangleCount(), 2u);
  const Mesh& mesh = model.meshes[0];
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool corner = mesh.positions[i] == glm::vec3(0, 1, 0);
    EXPECT_NEAR(mesh.colors[i].r, corner ? 0.0f : 1.0f, 1e-6f);
    EXPECT_NEAR(mesh.colors[i].b, corner ? 0.5029f : 0.0f, 1e-4f) << "sRGB decoded";
    EXPECT_EQ(mesh.normals[i], glm::vec3(0, 0, 1));
  }
}

TEST_F(ModelReader, StlAsTextAndBinary) {
  const Model binary = read("b.stl", binaryStl(1, 1));
  EXPECT_EQ(binary.triangleCount(), 1u);
  const Model text = read("t.STL",
                          "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 0\n"
                          "endloop\nendfacet\nendsolid one\n");
  for (const Model* model : {&binary, &text}) {
    const Mesh& mesh = model->meshes.at(0);
    ASSERT_EQ(mesh.indices.size(), 3u);
    EXPECT_EQ(mesh.positions[mesh.indices[1]], glm::vec3(2, 0, 0));
    EXPECT_EQ(mesh.normals[mesh.indices[1]], glm::vec3(0, 0, 1));
  }
}

TEST_F(ModelReader, StlAsItIsFound) {
  // Binary, though it starts with "solid" and holds the word "facet": the size tells.
  std::string solid = binaryStl(2, 2);
  solid.replace(0, 11, "solid facet");
  EXPECT_EQ(read("s.stl", solid).triangleCount(), 2u);
  EXPECT_EQ(read("more.stl", binaryStl(1, 1) + "trailing bytes").triangleCount(), 1u);
  const std::string triangle = "vertex 0 0 0\rvertex +2E0 0 0\rvertex 0 3 1e-60\r";
  const std::string text = "SOLID\rFACET NORMAL 0 0 1\router loop\r" + triangle + "ENDLOOP\rendfacet\rendsolid\r";
  EXPECT_EQ(read("c.stl", text).triangleCount(), 1u) << "capitals, carriage returns alone";
  const std::string lower = "solid a\nfacet normal 0 0 1\nouter loop\n" + triangle;
  expectRefused("m.stl", lower, "cut off");
  expectRefused("m.stl", lower + "vertex 1 1 1\nendloop", "has 4 vertices");
  expectRefused("m.stl", lower + "vertex 1 1", "is not a number");
  expectRefused("m.stl",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 0\nendloop\n",
                "not finite");
  // The language of the author's computer; each number stands between spaces, so nothing else can be meant.
  const Model commas = read("d.stl",
                            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0,5 0 0\nvertex -1,25e0 0 0\n"
                            "vertex 0 +3,5 0\nendloop\nendfacet\nendsolid\n");
  ASSERT_EQ(commas.triangleCount(), 1u);
  EXPECT_EQ(commas.meshes[0].positions[0], glm::vec3(0.5f, 0, 0));
  EXPECT_EQ(commas.meshes[0].positions[1], glm::vec3(-1.25f, 0, 0));
  EXPECT_EQ(commas.meshes[0].positions[2], glm::vec3(0, 3.5f, 0));
  EXPECT_EQ(commas.warnings, std::vector<std::string>{"has decimal commas, which are read as points"});
  for (const char* word : {"1,2,3", "1,000.5", ",5", "5,", "1,x"}) {
    expectRefused("m.stl", "solid a\nfacet\nouter loop\nvertex " + std::string(word) + " 0 0\n", "is not a number");
  }
  // A count that was never written, with triangles up to the end of the file.
  const Model uncounted = read("u.stl", binaryStl(0, 3));
  EXPECT_EQ(uncounted.triangleCount(), 3u);
  ASSERT_EQ(uncounted.warnings.size(), 1u);
  EXPECT_NE(uncounted.warnings[0].find("promises 0 triangles and holds 3"), std::string::npos);
  expectRefused("m.stl", binaryStl(0, 1) + "behind", "has no triangles");
  expectRefused("m.stl", "solid a\nfacet\nbanana\n", "m.stl:3: \"banana\" is not of STL");
}

TEST_F(ModelReader, PlyWithCarriageReturnsAlone) {
  std::string text = kPly;
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(read("m.ply", text).triangleCount(), 2u);
}

constexpr const char* kVtp =
    R"(<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 0 0 2 0 3 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>)";

TEST_F(ModelReader, VtpGetsNormals) {
  const Model model = read("m.vtp", kVtp);
  ASSERT_EQ(model.triangleCount(), 1u);
  EXPECT_EQ(model.meshes[0].normals[0], glm::vec3(-1, 0, 0));
}

// An edge sharper than 30 degrees stays sharp, a flatter one is smooth.
TEST_F(ModelReader, ComputedNormalsKeepSharpEdges) {
  for (const bool sharp : {false, true}) {
    const std::string height = sharp ? "2" : "0.2";
    const Model model = read("m.obj", "v -1 0 0\nv 0 0 " + height + "\nv 0 1 " + height +
                                          "\nv -1 1 0\nv 1 0 0\nv 1 1 0\n" + "f 1 2 3 4\nf 2 5 6 3\n");
    int upright = 0;
    const Mesh& mesh = model.meshes.at(0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (mesh.positions[i].x == 0.0f && mesh.normals[i].z > 0.999f) ++upright;
    }
    EXPECT_EQ(upright > 0, !sharp);
  }
}

TEST(ModelPlacement, UnitsAndUpAxis) {
  ModelFile file;
  file.unit = LengthUnit::Millimetre;
  file.upAxis = UpAxis::Z;
  file.scale = 2.0;
  file.translation = {10, 0, 0};
  const auto at = [&](double x, double y, double z) {
    return glm::dvec3(worldFromFile(file) * glm::dvec4(x, y, z, 1));
  };
  EXPECT_LT(glm::distance(at(0, 0, 1000), glm::dvec3(10, 2, 0)), 1e-12);   // up becomes +Y
  EXPECT_LT(glm::distance(at(1000, 0, 0), glm::dvec3(12, 0, 0)), 1e-12);   // and X stays
  EXPECT_LT(glm::distance(at(0, 1000, 0), glm::dvec3(10, 0, -2)), 1e-12);  // no mirroring
  file = ModelFile();
  file.upAxis = UpAxis::X;
  file.unit = LengthUnit::Inch;
  EXPECT_LT(glm::distance(at(1, 0, 0), glm::dvec3(0, 0.0254, 0)), 1e-12);
  EXPECT_LT(glm::distance(at(0, 0, 1), glm::dvec3(0, 0, 0.0254)), 1e-12);
}

TEST_F(ModelReader, BrokenFilesAreRefusedInOneLine) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectRefused("m.obj", v + "f 1 2 4\n", "m.obj:4: \"4\" refers to entry 4, but there are 3");
  expectRefused("m.obj", v + "f 1 2 -9\n", "-9");
  expectRefused("m.obj", v + "f 1 2 0\n", "indices start from 1");
  expectRefused("m.obj", v + "vt 0 0\nf 1/7 2/7 3/7\n", "there are 1");
  expectRefused("m.obj", v + "f a b c\n", "is not a corner");
  expectRefused("m.obj", v, "has no faces");
  expectRefused("m.obj", "", "has no faces");
  expectRefused("m.obj", std::string("v\0x", 3), "is not text");
  expectRefused("m.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj");
  expectRefused("m.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj");
  expectRefused("m.ply", "obj\n", "does not start with");
  expectRefused("m.ply", "ply\nformat ascii 1.0\n", "end_header");
  expectRefused("m.ply", "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\nend_header\n",
                "promises 1000000000");
  expectRefused("m.ply", "ply\nformat ascii 1.0\nelement vertex -4\nend_header\n", "promises -4");
  std::string ply = kPly;
  expectRefused("m.ply", ply.replace(ply.find("4 0 1 2 3"), 9, "4 0 1 2 9"), "corner 9");
  expectRefused("m.stl", "short", "is cut off");
  expectRefused("m.stl", binaryStl(1000000000, 1), "promises 1000000000 triangles, but holds 1");
  expectRefused("m.stl", binaryStl(0, 0), "has no triangles");
  expectRefused("m.vtp", "<html></html>", "is not a VTK XML file");
  std::string vtp = kVtp;
  expectRefused("m.vtp", vtp.replace(vtp.find("NumberOfPoints=\"3\""), 18, "NumberOfPoints=\"1000000000\""),
                "NumberOfPoints");
  vtp = kVtp;
  expectRefused("m.vtp", vtp.replace(vtp.find("0 1 2"), 5, "0 1 7"), "corner 7");
  expectRefused("m.vtp", std::string(kVtp).substr(0, 200), "m.vtp");
  expectRefused("m.3ds", "x", "m.3ds: 3D Studio files are not read; convert it with assimp-utils: assimp export");
  for (const char* other : {"m.fbx", "m.usd", "m.usda", "m.usdc", "m.usdz", "m.dae", "m.abc", "M.FBX"}) {
    expectRefused(other, "x", "files are not read; import it into Blender and export glTF");
  }
  expectRefused("m.blend", "x", "open it in Blender and export glTF");
  expectRefused("m.qqq", "x", ".qqq files are not supported");
}

}  // namespace
}  // namespace boxprobe
