// OBJ files as programs and people write them: names, line ends, indices, polygons, normals, objects. The fixture's
// triangle has corners at 0, 2 and 3 along its axes, so that no exchange of corners or axes goes unseen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/io/image/image_file.h"
#include "filters/vtk/import/model_reader.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

const std::string kObjTriangle = "v 0 0 0\nv 2 0 0\nv 0 3 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
const std::string kObjFace = "f 1/1/1 2/2/1 3/3/1\n";

class ObjFile : public TemporaryFolder {
 protected:
  Model load(const std::string& bytes) const { return readModel(write("m.obj", bytes)); }
  /// The base colour of the only material.
  glm::vec3 colorOf(const std::string& obj, const std::string& mtlName, const std::string& mtl) const {
    write(mtlName, mtl);
    const Model model = load(obj);
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    return model.materials.empty() ? glm::vec3(-1.0f) : glm::vec3(model.materials[0].baseColor);
  }
  static double areaOf(const Model& model) {
    double area = 0.0;
    for (const Mesh& mesh : model.meshes) {
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        area += 0.5 * glm::cross(b - a, c - a).z;  // signed: of a turned triangle negative
      }
    }
    return area;
  }
};

TEST_F(ObjFile, LinesEndAndContinueInEveryWay) {
  const std::string lines = "mtllib m.mtl\n" + kObjTriangle + "usemtl m\n" + kObjFace;
  const std::string mtl = "newmtl m\nKd .75 .5 .25\n";
  const glm::vec3 color(0.75f, 0.5f, 0.25f);
  const auto ended = [](std::string text, const std::string& end) {
    std::string result;
    for (const char c : text) result += c == '\n' ? end : std::string(1, c);
    return result;
  };
  for (const char* end : {"\n", "\r", "\r\n", "  \t\n"}) {
    EXPECT_EQ(colorOf(ended(lines, end), "m.mtl", ended(mtl, end)), color) << ::testing::PrintToString(end);
  }
  EXPECT_EQ(colorOf("\xef\xbb\xbf" + lines, "m.mtl", "\xef\xbb\xbf" + mtl), color) << "byte order mark";
  EXPECT_EQ(colorOf(lines, "m.mtl", "NEWMTL\tm\n\tKD\t.75 \\\n .5 .25\n"), color) << "tabs, case, continuation";
  const std::string continued = "f 1/1/1 2/2/1 \\\n 3/3/1\n";
  EXPECT_EQ(load(kObjTriangle + continued).triangleCount(), 1u);
  EXPECT_EQ(load("# C:\\models\\\n" + kObjTriangle + kObjFace).triangleCount(), 1u) << "a comment ends with its line";
  EXPECT_EQ(load(kObjTriangle + "f 1 2 3 # the only one\n").triangleCount(), 1u);
}

TEST_F(ObjFile, OddTextIsUnderstood) {
  const std::string lines = "mtllib m.mtl\n" + kObjTriangle + "usemtl \xc3\xbc\xe6\x9c\xa8\n" + kObjFace;
  write("m.mtl", "newmtl \xc3\xbc\xe6\x9c\xa8\nKd .75 .5 .25\n");
  for (const bool little : {true, false}) {
    std::string wide = little ? "\xff\xfe" : "\xfe\xff";
    const auto put = [&](int unit) {
      const char low = static_cast<char>(unit & 255), high = static_cast<char>(unit >> 8);
      wide += little ? std::string{low, high} : std::string{high, low};
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines.compare(i, 5, "\xc3\xbc\xe6\x9c\xa8") == 0) {
        put(0xfc);
        put(0x6728);
        i += 4;
      } else {
        put(lines[i]);
      }
    }
    const Model model = load(wide);
    EXPECT_EQ(glm::vec3(model.materials.at(0).baseColor), glm::vec3(0.75f, 0.5f, 0.25f)) << little;
  }
  const Model ghost = load("v 0 0 0\nv 2 0 0\nv 0 3 0\nf 1/1/1 2/2/2 3/3/3\n");
  EXPECT_EQ(ghost.triangleCount(), 1u) << "lists that the program left out";
  EXPECT_EQ(ghost.warnings.size(), 2u);
  const Model undefined = load("v 0 0 0\nv 2 0 0\nv 0 3 0\nvn 1.#IND 0 -1.#QNAN\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(undefined.meshes.at(0).normals.at(0), glm::vec3(0, 0, 1)) << "the face's own";
}

TEST_F(ObjFile, LibrariesOnOneLineAndOnSeveral) {
  const std::string body = kObjTriangle + "usemtl m\n" + kObjFace, mtl = "newmtl m\nKd .75 .5 .25\n";
  const glm::vec3 color(0.75f, 0.5f, 0.25f);
  EXPECT_EQ(colorOf("mtllib a name.mtl\n" + body, "a name.mtl", mtl), color);
  EXPECT_EQ(colorOf("mtllib \"a name.mtl\"\n" + body, "a name.mtl", mtl), color);
  EXPECT_EQ(colorOf("mtllib MIXED.MTL\n" + body, "Mixed.mtl", mtl), color);
  EXPECT_EQ(colorOf("mtllib C:\\work\\moved.mtl\n" + body, "moved.mtl", mtl), color);
  EXPECT_EQ(colorOf("mtllib .\\sub\\b.mtl\n" + body, "sub/b.mtl", mtl), color);
  write("first.mtl", "newmtl other\nKd 1 0 0\n");
  EXPECT_EQ(colorOf("mtllib first.mtl two words.mtl\n" + body, "two words.mtl", mtl), color);
  EXPECT_EQ(colorOf("mtllib first.mtl\nmtllib second.mtl\n" + body, "second.mtl", mtl), color);
  const Model missing = load("mtllib none here.mtl second.mtl\n" + body);
  ASSERT_EQ(missing.warnings.size(), 1u);
  EXPECT_EQ(missing.warnings[0], "has the material file none here.mtl, which does not exist; grey takes its place");
  EXPECT_EQ(glm::vec3(missing.materials.at(0).baseColor), color);
}

TEST_F(ObjFile, NothingOutsideTheFolderIsRead) {
  write("secret.mtl", "newmtl m\nKd 1 0 0\n");
  savePng(file("secret.png"), ImageRgba8{1, 1, {255, 0, 0, 255}, "secret"});
  const std::string path = write("inside/m.obj", "mtllib ../secret.mtl\n" + kObjTriangle + "usemtl m\n" + kObjFace);
  Model model = readModel(path);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("../secret.mtl, which lies outside the model's folder; put it inside"),
            std::string::npos);
  EXPECT_FLOAT_EQ(model.materials.at(0).baseColor.r, 0.8f);
  write("inside/m.obj", "mtllib m.mtl\n" + kObjTriangle + "usemtl m\n" + kObjFace);
  for (const std::string& name : {std::string("../secret.png"), file("secret.png")}) {
    write("inside/m.mtl", "newmtl m\nKd 1 1 1\nmap_Kd " + name + "\n");
    model = readModel(path);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("lies outside the model's folder"), std::string::npos) << model.warnings[0];
    EXPECT_FALSE(model.materials.at(0).baseColorTexture.image);
  }
  std::filesystem::create_symlink(file("secret.png"), folder_ / "inside" / "link.png");
  write("inside/m.mtl", "newmtl m\nmap_Kd link.png\n");
  EXPECT_FALSE(readModel(path).materials.at(0).baseColorTexture.image);
}

TEST_F(ObjFile, IndicesFromTheEndAndAheadAreFollowed) {
  const glm::vec3 expected[3] = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  for (const std::string& bytes :
       {kObjTriangle + kObjFace, kObjTriangle + "f -3/-3/-1 -2/-2/-1 -1/-1/-1\n", kObjFace + kObjTriangle}) {
    const Model model = load(bytes);
    const Mesh& mesh = model.meshes.at(0);
    ASSERT_EQ(mesh.indices.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.positions[mesh.indices[i]], expected[i]);
      EXPECT_EQ(mesh.normals[mesh.indices[i]], glm::vec3(0, 0, 1));
    }
    EXPECT_EQ(mesh.uv[mesh.indices[1]], glm::vec2(1, 1));  // v = 0 at the top
    EXPECT_EQ(mesh.uv[mesh.indices[2]], glm::vec2(0, 0));
  }
  EXPECT_NE(errorText([&] {
              load(kObjTriangle + "f 1 2 3\nf 1 2 4\n");
            }).find("m.obj:9: \"4\" refers to entry 4, but there are 3"),
            std::string::npos);
  EXPECT_NE(errorText([&] { load(kObjTriangle + "f 1 2 -4\n"); }).find("refers to entry -4"), std::string::npos);
}

// The signed area of the triangles is that of the outline only if they cover it once.
TEST_F(ObjFile, PolygonsAreCoveredOnce) {
  const auto area = [&](const std::string& points) {
    std::string text, face = "f";
    std::istringstream words(points);
    std::string x, y;
    for (int i = 1; words >> x >> y; ++i) {
      text += "v " + x + " " + y + " 0\n";
      face += " " + std::to_string(i);
    }
    const Model model = load(text + face + "\n");
    double sizes = 0.0;  // of folded triangles signs would cancel
    for (const Mesh& mesh : model.meshes) {
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        sizes += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                              glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a));
      }
    }
    EXPECT_NEAR(areaOf(model), sizes, 1e-6);
    return sizes;
  };
  EXPECT_NEAR(area("0 0  4 0  4 1  1 1  1 5  0 5"), 8.0, 1e-6) << "an L";
  EXPECT_NEAR(area("1 1  0 5  0 0  4 0"), 2.5 + 2.0, 1e-6) << "an arrow, its notch first";
  EXPECT_NEAR(area("0 0  6 0  6 3  5 3  5 1  4 1  4 3  3 3  3 1  2 1  2 4  0 4"), 18.0 - 2.0 - 2.0 + 2.0, 1e-6)
      << "a comb";
  // A hole, joined to the outline by a bridge that is passed twice.
  EXPECT_NEAR(area("0 0  9 0  9 7  0 7  0 0  2 2  2 4  5 4  5 2  2 2"), 63.0 - 6.0, 1e-6);
}

TEST_F(ObjFile, SmoothingGroupsSayWhatIsSmooth) {
  // A ridge along y with flanks of 45 degrees: too sharp to be smooth unasked.
  const std::string ridge = "v -1 0 0\nv 0 0 1\nv 0 5 1\nv -1 5 0\nv 1 0 0\nv 1 5 0\n";
  const std::string left = "f 1 2 3 4\n", right = "f 2 5 6 3\n";
  const auto atTop = [&](const std::string& bytes) {
    std::vector<float> ups;
    for (const Mesh& mesh : load(bytes).meshes) {
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].x == 0.0f) ups.push_back(mesh.normals[i].z);
      }
    }
    return std::make_pair(*std::min_element(ups.begin(), ups.end()), *std::max_element(ups.begin(), ups.end()));
  };
  const float flank = std::sqrt(0.5f);
  const auto smooth = atTop(ridge + "s 1\n" + left + right);
  EXPECT_NEAR(smooth.first, 1.0f, 1e-6f);
  for (const std::string& flat : {ridge + left + right, ridge + "s off\n" + left + right,
                                  ridge + "s 1\n" + left + "s 2\n" + right, ridge + "s 0\n" + left + right}) {
    EXPECT_NEAR(atTop(flat).second, flank, 1e-6f) << flat;
  }
}

TEST_F(ObjFile, ObjectsElseGroupsAreNodes) {
  write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const std::string faces = "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n";
  const auto nodes = [&](const std::string& bytes) {
    std::string names;
    const Model model = load("mtllib m.mtl\n" + kObjTriangle + bytes);
    for (const Instance& instance : model.instances) {
      const int material = model.meshes[static_cast<std::size_t>(instance.mesh)].material;
      names += instance.node + ":" + model.materials[static_cast<std::size_t>(material)].name + " ";
    }
    EXPECT_EQ(model.materials.size(), 2u) << "shared by the objects";
    return names;
  };
  EXPECT_EQ(nodes("o my chair\n" + faces + "o table\n" + faces), "my chair:red my chair:blue table:red table:blue ");
  EXPECT_EQ(nodes("g seat\n" + faces + "g leg\n" + faces + "g seat\n" + faces), "seat:red seat:blue leg:red leg:blue ");
  EXPECT_EQ(nodes("o all\ng seat\n" + faces + "g leg\nusemtl red\nf 1 2 3\n"), "seat:red seat:blue leg:red ");
  EXPECT_EQ(nodes(faces), "red:red blue:blue ");
}

TEST_F(ObjFile, ColoursOfVerticesAreNotDarkened) {
  const std::string face = "f 1 2 3\n";
  const std::string colored = "v 0 0 0 .7372549 .388 .196\nv 2 0 0 .7372549 .388 .196\nv 0 3 0 .7372549 .388 .196\n";
  const Model model = load(colored + face);
  EXPECT_EQ(model.materials.at(0).baseColor, glm::vec4(1.0f));
  EXPECT_NEAR(model.meshes.at(0).colors.at(0).r, std::pow((0.7372549 + 0.055) / 1.055, 2.4), 1e-6);
  write("m.mtl", "newmtl m\nKd .5 .5 .5\n");
  const Model tinted = load("mtllib m.mtl\n" + colored + "usemtl m\n" + face);
  EXPECT_FLOAT_EQ(tinted.materials.at(0).baseColor.r, 0.5f) << "a colour that the author gave multiplies";
  const Model bytes = load("v 0 0 0 188 99 50\nv 2 0 0 188 99 50\nv 0 3 0 188 99 50\n" + face);
  EXPECT_NEAR(bytes.meshes.at(0).colors.at(0).r, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
  EXPECT_EQ(bytes.warnings.size(), 1u);
  EXPECT_EQ(load(kObjTriangle + face).materials.at(0).baseColor.r, 0.8f) << "without colours it is grey";
}

TEST_F(ObjFile, WhatIsNotDrawnIsSaid) {
  const Model model = load(kObjTriangle + kObjFace + "l 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nbevel on\nf 1 2\n");
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(
      model.warnings[0],
      "has statements that are not drawn: bevel (1), curv (1), f with fewer than three corners (1), l (2), p (1)");
}

}  // namespace
}  // namespace boxprobe
