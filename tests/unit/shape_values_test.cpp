// Values of what files are made into, where a file of a few lines does not reach: polygons of many corners, points
// where many triangles meet, compressed buffers, cameras that cut off, long files and long lists of what is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "filters/io/mesh/polygon_triangles.h"
#include "filters/io/mesh/smooth_normals.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/model_values.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

/// The same numbers in each run and on each machine.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed) {}
  double next() {
    state_ = 1664525u * state_ + 1013904223u;
    return (state_ >> 8) / 16777216.0;
  }

 private:
  std::uint32_t state_;
};

using Points = std::vector<glm::dvec3>;

/// Polygons without symmetry: outlines around a point, of rising and falling radius, folded back, crossing themselves.
std::vector<Points> polygons() {
  std::vector<Points> all;
  Dice dice(11);
  for (const int corners : {4, 5, 7, 12, 23, 60}) {
    Points star, walk;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * (i + 0.6 * dice.next()) / corners, radius = 0.4 + 3.0 * dice.next();
      star.emplace_back(radius * std::cos(angle) + 5.0, 1.4 * radius * std::sin(angle) - 2.0, 0.3 * radius);
      walk.emplace_back(std::floor(4.0 * dice.next()), std::floor(3.0 * dice.next()), dice.next() < 0.5 ? 0.0 : 0.25);
    }
    all.push_back(star);
    all.push_back(walk);
  }
  // A bar whose outline runs out and back again, and one with a corner twice.
  all.push_back({{0, 0, 0}, {4, 0, 0}, {7, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 3, 0}});
  all.push_back({{0, 0, 0}, {3, 0, 0}, {3, 0, 0}, {3, 2, 0}, {1, 0.5, 0}, {0, 2, 0}});
  return all;
}

TEST(ShapeValues, PolygonsAreCutIntoTheseTriangles) {
  std::vector<std::string> kept;
  for (const Points& shape : polygons()) {
    for (int turn = 0; turn < 3; ++turn) {
      for (const bool back : {false, true}) {
        Points points;
        for (const glm::dvec3& p : shape) {
          const double out = 0.5 * p.x - 0.25 * p.y + p.z;
          points.push_back(turn == 0   ? glm::dvec3(p.x, p.y, out)
                           : turn == 1 ? glm::dvec3(out, p.x, p.y)
                                       : glm::dvec3(p.y, out, p.x));
        }
        if (back) std::reverse(points.begin(), points.end());
        PolygonTests tests;
        const std::uint64_t all = tests.left;
        std::string line =
            std::to_string(points.size()) + " corners, turn " + std::to_string(turn) + (back ? ", back:" : ":");
        for (const auto& [a, b, c] : polygonTriangles(points, tests)) {
          line += " " + std::to_string(a) + "-" + std::to_string(b) + "-" + std::to_string(c);
        }
        kept.push_back(line + " after " + std::to_string(all - tests.left));
      }
    }
  }
  test::expectKeptValues("unit/values/polygons.txt", kept);
}

class ManyValues : public ModelValues {
 protected:
  void add(const std::string& what, const std::vector<std::string>& lines) {
    kept_.push_back("== " + what);
    kept_.insert(kept_.end(), lines.begin(), lines.end());
  }
  std::vector<std::string> kept_;
};

/// A crumpled fan around one point, of more triangles than are kept apart there.
TEST_F(ManyValues, OfWhereManyTrianglesMeet) {
  for (const int count : {9, 65}) {
    Dice dice(static_cast<std::uint32_t>(count));
    Mesh mesh;
    std::vector<glm::vec3> rim;
    for (int i = 0; i < count; ++i) {
      const double angle = 6.283185307179586 * i / count, high = 1.5 * std::sin(3.0 * angle) + 0.2 * dice.next();
      rim.emplace_back(std::cos(angle) * (1.0 + dice.next()), high, std::sin(angle) * (1.0 + dice.next()));
    }
    for (std::size_t i = 0; i < rim.size(); ++i) {
      for (const glm::vec3& p : {glm::vec3(0.1f, 0.2f, 0.3f), rim[i], rim[(i + 1) % rim.size()]}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(p);
        mesh.colors.emplace_back(p, 0.5f);
        mesh.uv.emplace_back(p.x, 2.0f * p.z);
      }
    }
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1});  // of no area
    computeNormals(mesh);
    Model model;
    model.meshes.push_back(mesh);
    add(std::to_string(count), modelLines(model, ""));
  }
  test::expectKeptValues("unit/values/fans.txt", kept_);
}

TEST_F(ManyValues, OfPlacesFarAway) {
  // The middle along the first axis is at 4 times the size, and then beyond it.
  for (const char* far : {"3.375", "3.5", "3.6", "-4.6", "1000000.25"}) {
    for (const int axis : {0, 1, 2}) {
      std::string text;
      for (const char* corner : {"0.125 0.25 0.5", "1.125 0.5 0.25", "0.5 0.75 1.25"}) {
        double at[3] = {};
        std::sscanf(corner, "%lf %lf %lf", &at[0], &at[1], &at[2]);
        at[axis] += std::stod(far);
        text += "v " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]) + "\n";
      }
      add(std::string(far) + " along " + std::to_string(axis), linesOf("far.obj", text + "f 1 2 3\n"));
    }
  }
  test::expectKeptValues("unit/values/far.txt", kept_);
}

/// A small triangle in front of a camera that looks to +X, at these distances ahead, upwards and to the right.
TEST_F(ManyValues, OfCamerasThatCutOff) {
  const auto told = [this](const Json& camera, double ahead, double up, double right) {
    GlbBuilder glb;
    const auto x = static_cast<float>(ahead + 2.0), y = static_cast<float>(up + 1.0),
               z = static_cast<float>(right - 3.0);
    const float small = 1e-4f;
    const int positions = glb.floats("VEC3", 3, {x, y, z, x + small, y, z, x, y, z + small});
    glb.node({{"mesh", glb.mesh({{"attributes", {{"POSITION", positions}}}})}});
    glb.node({{"camera", 0}, {"translation", {2, 1, -3}}, {"rotation", {0, -std::sqrt(0.5), 0, std::sqrt(0.5)}}});
    glb.json["cameras"] = {camera};
    const std::vector<std::string> lines = linesOf("m.glb", glb.glb());
    const std::string last = lines.back();
    return last.find("warning") == std::string::npos ? std::string("nothing") : last;
  };
  const Json wide = {{"type", "perspective"},
                     {"perspective", {{"yfov", 2.0 * std::atan(0.5)}, {"znear", 0.5}, {"zfar", 20}}}};
  const Json endless = {{"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 2}}}};
  const Json plan = {{"type", "orthographic"},
                     {"orthographic", {{"xmag", 1.5 * 16 / 9}, {"ymag", 1.5}, {"znear", 0.5}, {"zfar", 20}}}};
  const double places[][3] = {{0.49, 0, 0},    {0.51, 0, 0},    {19.9, 0, 0},    {20.1, 0, 0},    {-0.3, 0, 0},
                              {0.4, 0.19, 0},  {0.4, 0.21, 0},  {0.4, -0.19, 0}, {0.4, -0.21, 0}, {0.4, 0, 0.79},
                              {0.4, 0, 0.81},  {0.4, 0, -0.79}, {0.4, 0, -0.81}, {30, 14.9, 0},   {30, 15.1, 0},
                              {30, 0, 59.9},   {30, 0, -60.1},  {30, 1.49, 0},   {30, -1.51, 0},  {0.4, 0, 5.99},
                              {0.4, 0, -6.01}, {1.9, 0, 0},     {2.1, 0, 0},     {1e6, 0, 0}};
  for (const auto& [ahead, up, right] : places) {
    const std::string place = std::to_string(ahead) + " " + std::to_string(up) + " " + std::to_string(right);
    add(place, {told(wide, ahead, up, right), told(endless, ahead, up, right), told(plan, ahead, up, right)});
  }
  for (const double aspect : {16 / 9.0, 1.79, 1.795, 1.8, 1.76, 0.001, 50.0}) {
    Json camera = wide;
    camera["perspective"]["aspectRatio"] = aspect;
    add("aspect " + std::to_string(aspect), {told(camera, 1, 0, 0)});
  }
  test::expectKeptValues("unit/values/clips.txt", kept_);
}

/// Each number and word of the codecs' extensions in a .glb as another one.
TEST_F(ManyValues, OfCodecs) {
  for (const char* name : {"torus-meshopt.glb", "torus-draco.glb"}) {
    std::ifstream stream(std::string(BOXPROBE_SOURCE_DIR "/tests/unit/models/") + name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, 4);
    const Json whole = Json::parse(bytes.substr(20, size));
    const auto lines = [&](const Json& json) {
      std::string text = json.dump();
      text.resize((text.size() + 3) / 4 * 4, ' ');
      std::string file = bytes.substr(0, 20) + text + bytes.substr(20 + size);
      const auto length = static_cast<std::uint32_t>(file.size()), chunk = static_cast<std::uint32_t>(text.size());
      std::memcpy(file.data() + 8, &length, 4);
      std::memcpy(file.data() + 12, &chunk, 4);
      return linesOf("m.glb", file);
    };
    const std::vector<std::string> before = lines(whole);
    add(name, {std::to_string(before.size()), before[before.size() / 2]});
    const auto change = [&](const std::string& path, const Json& to) {
      Json json = whole;
      json[Json::json_pointer(path)] = to;
      kept_.push_back(path + " = " + to.dump() + ": " + differenceOf(before, lines(json)));
    };
    const Json flat = whole.flatten();
    for (const auto& [path, value] : flat.items()) {
      if (path.find("EXT_meshopt") == std::string::npos && path.find("KHR_draco") == std::string::npos) continue;
      if (path.find("/extensions/") == std::string::npos) continue;
      if (value.is_number()) {
        const double number = value;
        for (const double other : {number + 1, number - 1, number + 4, 0.0, 2.0, 3.0, 256.0, 260.0, 9e15}) {
          if (other == std::floor(other) && other < 1e10) {
            change(path, static_cast<long long>(other));
          } else {
            change(path, other);
          }
        }
      } else {
        for (const char* other :
             {"TRIANGLES", "INDICES", "ATTRIBUTES", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "NONE", "x"}) {
          change(path, other);
        }
      }
    }
  }
  test::expectKeptValues("unit/values/codecs.txt", kept_);
}

/// What is reported while files are read that are long enough for it.
TEST_F(ManyValues, OfProgress) {
  const auto reported = [this](const std::string& name, const std::string& bytes) {
    const std::string path = write(name, bytes);
    std::string line = name + ":";
    const Model model = readModel(path, [&line](double done) {
      char text[16];
      std::snprintf(text, sizeof text, " %.4f", done);
      line += text;
      return true;
    });
    kept_.push_back(line + ", " + std::to_string(model.triangleCount()) + " triangles");
  };
  const std::string triangle = "v 0 0 0\nv 2 0 0\nv 0 1 0\n";
  std::string faces;
  for (int i = 0; i < 40000; ++i) faces += "f 1 2 3\n";
  reported("m.obj", triangle + faces);
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 70000\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 1 0\n";
  for (int i = 0; i < 70000; ++i) ply += "3 0 1 2\n";
  reported("m.ply", ply);
  std::string stl(84, '\0');
  const std::uint32_t count = 140000;
  std::memcpy(stl.data() + 80, &count, 4);
  stl.resize(84 + 50 * std::size_t(count), '\0');
  const float corners[9] = {0, 0, 0, 2, 0, 0, 0, 1, 0};
  std::memcpy(stl.data() + 84 + 12, corners, sizeof corners);
  reported("m.stl", stl);
  reported("m.vtp", bytesOf("whole.vtp"));
  GlbBuilder glb;
  for (int i = 0; i < 3; ++i) glb.triangle();
  reported("m.glb", glb.glb());
  test::expectKeptValues("unit/values/progress.txt", kept_);
}

TEST_F(ManyValues, OfLongListsOfWhatIsWrong) {
  const std::string triangle = "v 0 0 0\nv 2 0 0\nv 0 1 0\n";
  std::string obj = triangle + "mtllib m.mtl\nusemtl one\nf 1 2 3\n", mtl = "newmtl one\n";
  for (int i = 10; i < 40; ++i) {
    const std::string number = std::to_string(i);
    obj += "word" + number + " 1\n";
    mtl += "Unknown" + number + std::string(static_cast<std::size_t>(i), 'x') + " 1\nNs wrong" + number + "\n";
  }
  obj += "word10 2\nword39 2\n" + std::string(50, 'k') + " 3\n";
  write("m.mtl", mtl);
  add("statements", linesOf("m.obj", obj));
  // 1000 objects are drawn each, one more is not.
  for (const int count : {999, 1000, 1001}) {
    for (const char* key : {"o", "g"}) {
      std::string text = triangle;
      for (int i = 0; i < count; ++i) text += std::string(key) + " part" + std::to_string(i) + "\nf 1 2 3\n";
      const std::vector<std::string> lines = linesOf("m.obj", text);
      add(std::to_string(count) + " " + key, {std::to_string(lines.size()), lines.back()});
    }
  }
  // Names of any language, in both orders of bytes, are those of UTF-8.
  const std::string name =
      "k\xc3\xbc"
      "che \xe6\x9c\xa8\xf0\x9f\x8f\xa0 \xdf\xbf\xe0\xa0\x80\xf4\x8f\xbf\xbf";
  const std::uint16_t units[] = {'k',    0xfc,   'c', 'h',   'e',   ' ',    0x6728,
                                 0xd83c, 0xdfe0, ' ', 0x7ff, 0x800, 0xdbff, 0xdfff};
  const std::string before = triangle + "o ", after = "\nf 1 2 3\n";
  const std::vector<std::string> wanted = linesOf("m.obj", before + name + after);
  for (const bool big : {false, true}) {
    std::string wide;
    const auto put = [&](unsigned unit) {
      const char low = static_cast<char>(unit & 255), high = static_cast<char>(unit >> 8);
      wide += big ? std::string{high, low} : std::string{low, high};
    };
    put(0xfeff);
    for (const char c : before) put(static_cast<unsigned char>(c));
    for (const std::uint16_t unit : units) put(unit);
    for (const char c : after) put(static_cast<unsigned char>(c));
    EXPECT_EQ(linesOf("m.obj", wide), wanted);
  }
  add("names", wanted);
  test::expectKeptValues("unit/values/lists.txt", kept_);
}

}  // namespace
}  // namespace boxprobe
