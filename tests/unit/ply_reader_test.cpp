// PLY files as people have them, and damaged ones: each is read right or refused in one line.
#include "filters/vtk/import/ply_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "filters/vtk/import/model_reader.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

const std::string kText = "ply\nformat ascii 1.0\n";
const std::string kVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kEnd = "end_header\n";
const std::string kHeader = kText + kVertex + kFace + kEnd;
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

template <typename T>
std::string raw(std::initializer_list<T> values, bool bigEndian = false) {
  std::string bytes;
  for (const T value : values) {
    std::string one(sizeof(T), '\0');
    std::memcpy(one.data(), &value, sizeof(T));
    bytes += bigEndian ? std::string(one.rbegin(), one.rend()) : one;
  }
  return bytes;
}

class PlyReader : public TemporaryFolder {
 protected:
  /// The whole message behind the folder, and nothing on the terminal.
  void expectRefused(const std::string& bytes, const std::string& message) const {
    const std::string path = write("m.ply", bytes);
    testing::internal::CaptureStderr();
    const std::string text = errorText([&] { readModel(path); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << message;
    EXPECT_EQ(text, path + message);
  }
  Model expectTriangles(const std::string& bytes, std::size_t triangles) const {
    const std::string path = write("m.ply", bytes);
    testing::internal::CaptureStderr();
    Model model;
    EXPECT_NO_THROW(model = readModel(path));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(model.triangleCount(), triangles);
    return model;
  }
  Model expectTriangle(const std::string& bytes) const {
    Model model = expectTriangles(bytes, 1);
    if (model.meshes.empty()) return model;
    const Mesh& mesh = model.meshes[0];
    const glm::vec3 expected[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.positions.at(mesh.indices.at(i)), expected[i]);
    return model;
  }
};

TEST_F(PlyReader, HeadersAreReadStrictly) {
  const std::string face = "3 0 1 2\n";
  expectRefused(replaced(kHeader, "float z", "wrong z") + kPoints + face,
                ":6: \"wrong\" is not a type; write char, uchar, short, ushort, int, uint, float or double");
  expectRefused("ply\nformat\nelement vertex 3\nend_header\n",
                ":2: the format line is not complete; write \"format ascii 1.0\" if the body is text");
  const std::string property =
      "the property line is not complete; write \"property TYPE NAME\" or \"property list TYPE "
      "TYPE NAME\"";
  expectRefused(replaced(kHeader, "element face", "property\nelement face") + kPoints + face, ":7: " + property);
  expectRefused(replaced(kHeader, "list uchar int", "list uchar") + kPoints + face, ":8: " + property);
  expectRefused(replaced(kHeader, "format ascii 1.0\n", "") + kPoints + face,
                ":8: has no format line; write \"format ascii 1.0\" below \"ply\" if the body is text");
  expectRefused(replaced(kHeader, "ascii", "text") + kPoints + face,
                ":2: \"text\" is not a format; ascii, binary_little_endian and binary_big_endian are");
  expectRefused(replaced(kHeader, "1.0", "2.0") + kPoints + face,
                ":2: version \"2.0\" is not supported; save the file as PLY 1.0");
  expectRefused(replaced(kHeader, "list uchar int", "int") + kPoints + "3\n",
                ":8: \"vertex_indices\" is a number where a list is needed; save the file again");
  expectRefused(replaced(kHeader, "float y", "list uchar float y") + kPoints + face,
                ":5: \"y\" is a list where a number is needed; save the file again");
  expectRefused(replaced(kHeader, "vertex_indices", "corners") + kPoints + face,
                ":7: \"face\" has no list of corners; name it \"vertex_indices\", as in \"property list uchar int "
                "vertex_indices\"");
  expectRefused(replaced(kHeader, "property float z\n", "") + kPoints + face,
                ":3: \"vertex\" has no property \"z\"; save the file again");
  expectRefused(replaced(kHeader, "element vertex", "property float q\nelement vertex") + kPoints + face,
                ":3: the property stands before any element; move it behind its element line");
  expectRefused(replaced(kHeader, kFace, "element vertex 3\nproperty float x\n" + kFace) + kPoints + "1\n1\n1\n" + face,
                ":7: element \"vertex\" stands in line 3 already; join the two");
  expectRefused(kText + kVertex + "element edge 0\n" + kFace + kEnd + kPoints + face,
                ":7: element \"edge\" has no properties; delete it");
  expectRefused(kText + kFace + kEnd + face, ":5: has no element \"vertex\"; save the file again");
  expectRefused(replaced(kHeader, "vertex 3", "vertex 3x") + kPoints + face,
                ":3: \"3x\" is not a count of \"vertex\"; write a whole number");
  expectRefused(replaced(kHeader, "element face", "\nelement face") + kPoints + face,
                ":7: the header has an empty line; delete it");
  expectRefused(replaced(kHeader, "property float z", "property float z" + std::string(5000, ' ')) + kPoints + face,
                ":6: the line is longer than 4080 characters; shorten it");
}

TEST_F(PlyReader, TextBodiesHaveTheirWords) {
  expectRefused(kHeader + "\n" + kPoints + "\n",
                ":15: the file ends here, but 1 of \"face\" are promised; the file is cut off");
  expectRefused(kHeader + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                ":10: the line has 2 words, too few for \"z\"; complete the line");
  expectRefused(kHeader + "0 0 a\n1 0 0\n0 1 0\n3 0 1 2\n", ":10: \"a\" is not a number (\"z\"); correct it");
  expectRefused(kHeader + kPoints, ":13: the file ends here, but 1 of \"face\" are promised; the file is cut off");
  for (const auto& [count, corners, found] :
       {std::array{"3", "0 1", "2"}, std::array{"200", "0 1 2", "3"}, std::array{"2147483647", "0 1 2", "3"}}) {
    expectRefused(kHeader + kPoints + count + " " + corners + "\n",
                  std::string(":13: \"vertex_indices\" is a list of ") + count + ", but " + found +
                      " words follow; complete the line or correct the count");
  }
  expectRefused(kHeader + kPoints + "-3 0 1 2\n", ":13: a list of -3 entries is not possible; the file is damaged");
  expectRefused(kHeader + kPoints + "1e1 0 1 2 0 1 2 0 1 2 0\n",
                ":13: \"1e1\" is not a whole number (\"vertex_indices\"); correct it");
  for (const char* corner : {"3", "-1"}) {
    expectRefused(
        kHeader + kPoints + "3 0 1 " + corner + "\n",
        std::string(":13: corner ") + corner + " is not among the 3 vertices, which count from 0; the file is damaged");
  }
  std::string many = "4097";
  for (int i = 0; i < 4097; ++i) many += " " + std::to_string(i % 3);
  expectRefused(kHeader + kPoints + many + "\n", ":13: the polygon has 4097 corners; split it, 4096 are possible");
}

TEST_F(PlyReader, BinaryBodiesAreAsLongAsTheyPromise) {
  const std::string header = replaced(replaced(kHeader, "ascii", "binary_little_endian"), "uchar int", "int int");
  const std::string points = raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  expectTriangle(header + points + raw({3, 0, 1, 2}));
  expectRefused(
      header + points + raw({2147483647, 0}),
      ": face 0: \"vertex_indices\" is a list of 2147483647, more than the rest of the file holds; the file is "
      "damaged or cut off");
  expectRefused(header + points + raw({-3, 0, 1, 2}),
                ": face 0: a list of -3 entries is not possible; the file is damaged");
  expectRefused(header + points + raw({3, 0, 1, 3}),
                ": face 0: corner 3 is not among the 3 vertices, which count from 0; the file is damaged");
  expectRefused(header + points.substr(0, 30),
                ": vertex 2: the file ends here, but 3 of \"vertex\" are promised; the file is cut off");
  expectRefused(header + points, ": face 0: the file ends here, but 1 of \"face\" are promised; the file is cut off");
  const std::string big = replaced(header, "little", "big");
  expectTriangle(big + raw<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, true) + raw({3, 0, 1, 2}, true));
}

TEST_F(PlyReader, LegalFilesAreRead) {
  std::string lines = kHeader + kPoints + "3 0 1 2\n", crlf;
  for (const char c : lines) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  expectTriangle(crlf);
  expectTriangle(lines.substr(0, lines.size() - 1));
  expectTriangle(kHeader + kPoints + "3 0 1" + std::string(9000, ' ') + "2\n");
  expectTriangle(kText + kFace + kVertex + kEnd + "3 0 1 2\n" + kPoints);
  expectTriangle(kText + kVertex + "element edge 1\nproperty int a\n" + kFace + kEnd + kPoints + "1\n3 0 1 2\n");
  expectTriangle(replaced(lines, "element vertex", "comment " + std::string(9000, 'a') + "\nelement vertex"));
  expectTriangle(replaced(lines, "float x", "float32 x"));
  expectTriangle(replaced(lines, "list uchar int vertex_indices", "list uint8 uint16 vertex_index"));
  expectTriangle(replaced(lines, kEnd, "element edge 2\nproperty list uchar int any\n" + kEnd));
  // Lists before and behind the corners.
  const std::string lists =
      "element face 1\nproperty list uchar int q\nproperty list uchar int vertex_indices\n"
      "property uchar red\nproperty list uchar float texcoord\n";
  expectTriangle(kText + kVertex + lists + kEnd + kPoints + "2 7 7 3 0 1 2 5 6 0 0 1 0 0 1\n");
  const Model colored =
      expectTriangle(kText + kVertex + "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n" +
                     "property uchar green\nproperty uchar blue\nproperty float u\nproperty float v\n" + kFace + kEnd +
                     "0 0 0 0 0 -1 255 0 0 .25 .5\n1 0 0 0 0 -1 255 0 0 0 0\n0 1 0 0 0 -1 255 0 0 0 0\n3 0 1 2\n");
  ASSERT_EQ(colored.meshes.size(), 1u);
  EXPECT_EQ(colored.meshes[0].normals.at(0), glm::vec3(0, 0, -1));
  EXPECT_EQ(colored.meshes[0].colors.at(0), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(colored.meshes[0].uv.at(0), glm::vec2(0.25f, 0.5f));
}

TEST_F(PlyReader, AReturnWithinALineEndsNone) {
  const std::string bytes = kText + "comment one\rproperty float x\n" + kVertex + kFace + kEnd + kPoints + "3 0\r1 2\n";
  expectTriangle(bytes);
  expectTriangle(replaced(bytes, "comment one\r", "comment one\r\n comment "));
}

}  // namespace
}  // namespace boxprobe
