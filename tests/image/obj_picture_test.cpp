// OBJ and PLY files, drawn: where a picture's options put it, normals of a bump map, and coordinates of maps.
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/image/gltf_picture.h"

namespace boxprobe::test {
namespace {

class ObjPicture : public GltfPicture {
 protected:
  /// Draws a scene of one model, which is taken as it stands.
  void drawModel(const std::string& name, const std::string& bytes) {
    write(name, bytes);
    drawFile(write("scene.boxprobe.json", Json({{"format", "boxprobe-scene"},
                                                {"version", 1},
                                                {"model", name},
                                                {"sky", {{"color", {0, 0, 0}}}},
                                                {"lights", Json::array()}})
                                              .dump()));
  }
  /// A square from -1 to 1 with coordinates from 0 to 1, v upwards, in the material m.
  void drawSquare(const std::string& mtl) {
    write("m.mtl", "newmtl m\n" + mtl);
    drawModel("m.obj",
              "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
              "usemtl m\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
  }
};

// Sixteen columns of which the left half is green; the lower rows are dark.
TEST_F(ObjPicture, OptionsPlaceThePicture) {
  std::vector<std::uint8_t> texels;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const std::uint8_t full = y < 8 ? 255 : 0;  // the upper half
      texels.insert(texels.end(), {0, x < 8 ? full : std::uint8_t(0), x < 8 ? std::uint8_t(0) : full, 255});
    }
  }
  savePng(file("t.png"), ImageRgba8{16, 16, texels, "t"});
  drawSquare("Kd 1 1 1\nillum 0\nmap_Kd -s 2 1 1 -o .25 .5 0 t.png\n");
  for (int y = 5; y < kSize; y += 9) {
    for (int x = 5; x < kSize; x += 9) {
      const double u = 2.0 * share(x) + 0.25, v = (1.0 - share(y)) + 0.5;  // MTL's words
      const double column = 16.0 * (u - std::floor(u)), row = 16.0 * (v - std::floor(v));
      const auto near = [](double at) {
        return std::min({std::fabs(at), std::fabs(at - 8.0), std::fabs(at - 16.0)}) < 1.0;
      };
      if (near(column) || near(row)) continue;  // where texels are mixed
      const float full = row > 8.0 ? 1.0f : 0.0f;
      expectPixel(x, y, {0.0f, column < 8.0 ? full : 0.0f, column < 8.0 ? 0.0f : full});
    }
  }
  expectTracedAlike();
}

TEST_F(ObjPicture, BumpMapsTurnNormals) {
  savePng(file("n.png"), ImageRgba8{1, 1, {178, 230, 200, 255}, "n"});
  drawSquare("Kd 1 1 1\nbump -bm .5 n.png\n");
  glm::vec3 expected = glm::vec3(178, 230, 200) / 255.0f * 2.0f - 1.0f;
  expected = glm::normalize(expected * glm::vec3(0.5f, 0.5f, 1.0f));
  const glm::vec3 n = surfaceAt(20, 44).normalWorld;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(n[i], expected[i], 2e-5f) << i;
}

// 431 km east, 5412 km north: single precision has steps of half a unit there, a quarter of the picture.
TEST_F(ObjPicture, CoordinatesOfMapsAreDrawnAsNearTheOrigin) {
  const glm::dvec3 place(431000.37, 5411932.62, 312.25);
  const std::vector<glm::dvec3> points = {{-0.8, -0.6, 0}, {0.3, -0.8, 0}, {0.7, 0.4, 0}, {-0.2, 0.9, 0}};
  const auto file = [&](bool ply, const glm::dvec3& at) {
    std::string text = ply ? "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                             "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                             "element face 1\nproperty list uchar int vertex_index\nend_header\n"
                           : "mtllib m.mtl\nusemtl m\n";
    for (const glm::dvec3& p : points) {
      char line[128];
      std::snprintf(line, sizeof(line), ply ? "%.4f %.4f %.4f 255 9 8\n" : "v %.4f %.4f %.4f\n", at.x + p.x, at.y + p.y,
                    at.z + p.z);
      text += line;
    }
    return text + (ply ? "4 0 1 2 3\n" : "f 1 2 3 4\n");
  };
  write("m.mtl", "newmtl m\nKd 1 .5 .25\nillum 0\n");
  sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  for (const bool ply : {false, true}) {
    const std::string name = ply ? "m.ply" : "m.obj";
    middle = glm::dvec3(0.0);
    drawModel(name, file(ply, middle));
    const ImageRgbaF near = image;
    middle = place;
    drawModel(name, file(ply, middle));
    int covered = 0, different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      covered += near.pixels[i + 3] > 0.5f ? 1 : 0;
      different += std::fabs(image.pixels[i + 2] - near.pixels[i + 2]) > 1e-3f ? 1 : 0;
    }
    EXPECT_GT(covered, kSize * kSize / 5) << name;
    EXPECT_LE(different, 2) << name << ": of the outline's pixels rounding may decide one";
  }
}

}  // namespace
}  // namespace boxprobe::test
