// The scenes that come with the program: what the other tests and data/scenes/README.md say about them, read from the
// files.
#include "data/scenes/scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "data/environments/studio.h"
#include "data/scenes/glb_writer.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/math/shared/shared_math.h"
#include "tests/unit/scene_triangles.h"

namespace boxprobe {
namespace {

const std::string kFolder = scenesFolder();

std::string fileBytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class CheckedInScene : public testing::TestWithParam<const char*> {
 protected:
  Scene scene = loadSceneFile(kFolder + GetParam() + ".boxprobe.json");
  Model model = loadModelFile(kFolder + GetParam() + ".glb");
};

TEST_P(CheckedInScene, FrontFacesLieWhereTheNormalsPoint) {
  for (const Triangle& t : triangles(model)) {
    ASSERT_GT(glm::length(t.areaVector()), 1e-9) << t.node << ": a triangle without area";
    for (const glm::dvec3& normal : t.normals)
      ASSERT_GT(glm::dot(glm::normalize(t.areaVector()), normal), 0.3) << t.node << ": winding against normal";
  }
}

TEST_P(CheckedInScene, EveryOverrideNamesSomethingInTheModel) {
  EXPECT_THAT(unmatchedOverrides(scene, {&model}), testing::IsEmpty());
  EXPECT_THAT(featuresNotUsed(scene), testing::IsEmpty());
  EXPECT_THAT(model.warnings, testing::IsEmpty());
}

TEST_P(CheckedInScene, MirrorBallsAreSmoothWhiteMetalThatProbesDoNotSee) {
  int balls = 0;
  for (const Instance& instance : model.instances) {
    if (!startsWith(instance.node, "sphere") && instance.node != "ball") continue;
    ++balls;
    EXPECT_FALSE(scene.objects.at(instance.node).seenByProbes) << instance.node;
    const Mesh& mesh = model.meshes.at(static_cast<std::size_t>(instance.mesh));
    const Material& material = model.materials.at(static_cast<std::size_t>(mesh.material));
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.roughness, 0.0f);
    EXPECT_EQ(material.baseColor, glm::vec4(1.0f));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      ASSERT_NEAR(glm::dot(glm::normalize(mesh.positions[i]), mesh.normals[i]), 1.0f, 1e-5f);
  }
  const std::map<std::string, int> expected = {{"building", 9}, {"flat", 0},        {"room", 3},      {"furnished", 2},
                                               {"gallery", 1},  {"mirror-hall", 0}, {"six-faces", 1}, {"windows", 0}};
  EXPECT_EQ(balls, expected.at(GetParam()));
}

/// Whether two triangles of one plane overlap by more than a line: no edge of either has the other on its far side.
bool overlapInPlane(const Triangle& a, const Triangle& b, const glm::dvec3& normal) {
  for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 corner = first->corners[k];
      const glm::dvec3 inwards = glm::normalize(glm::cross(normal, first->corners[(k + 1) % 3] - corner));
      if (std::all_of(second->corners.begin(), second->corners.end(),
                      [&](const glm::dvec3& c) { return glm::dot(c - corner, inwards) < 1e-5; }))
        return false;
    }
  }
  return true;
}

TEST_P(CheckedInScene, NoTwoFacesFlickerInOnePlane) {
  std::vector<Triangle> all;
  for (const Triangle& t : triangles(model)) {
    const auto object = scene.objects.find(t.node);
    if (object == scene.objects.end() || object->second.visible) all.push_back(t);
  }
  // By their westernmost corners: what overlaps does so along x, too.
  const auto west = [](const Triangle& t) { return std::min({t.corners[0].x, t.corners[1].x, t.corners[2].x}); };
  std::sort(all.begin(), all.end(), [&](const Triangle& a, const Triangle& b) { return west(a) < west(b); });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::dvec3 normal = glm::normalize(all[i].areaVector());
    const double east = std::max({all[i].corners[0].x, all[i].corners[1].x, all[i].corners[2].x});
    for (std::size_t j = i + 1; j < all.size() && west(all[j]) < east + 1e-5; ++j) {
      const glm::dvec3 offset = all[j].corners[0] - all[i].corners[0];
      if (std::abs(glm::dot(offset, normal)) > 1e-5 || glm::dot(glm::normalize(all[j].areaVector()), normal) < 0.999999)
        continue;
      ASSERT_FALSE(overlapInPlane(all[i], all[j], normal))
          << all[i].node << " and " << all[j].node << " near (" << all[j].middle().x << ", " << all[j].middle().y
          << ", " << all[j].middle().z << ")";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, CheckedInScene,
                         testing::Values("building", "flat", "furnished", "gallery", "mirror-hall", "room", "six-faces",
                                         "windows"),
                         [](const auto& scene) { return std::string(scene.param).substr(0, 3); });

TEST(SceneGenerator, WritesTheCheckedInFiles) {
  const std::map<std::string, std::string> made = {
      {"building.glb", scenes::glbBytes(scenes::building())},
      {"flat.glb", scenes::glbBytes(scenes::flat(), scenes::kFlatJpegQuality)},
      {"flat-sky.hdr", scenes::flatSkyHdr()},
      {"furnished.glb", scenes::glbBytes(scenes::furnished())},
      {"gallery.glb", scenes::glbBytes(scenes::gallery())},
      {"glass.glb", scenes::glbBytes(scenes::glassRoom())},
      {"room.glb", scenes::glbBytes(scenes::room())},
      {"mirror-hall.glb", scenes::glbBytes(scenes::mirrorHall())},
      {"six-faces.glb", scenes::glbBytes(scenes::sixFaces())},
      {"sky.hdr", scenes::skyHdr()},
      {"windows.glb", scenes::glbBytes(scenes::windows())}};
  for (const auto& [name, bytes] : made) {
    const std::string stored = fileBytes(kFolder + name);
    const auto differ = std::mismatch(bytes.begin(), bytes.end(), stored.begin(), stored.end());
    EXPECT_TRUE(bytes == stored) << name << ": " << bytes.size() << " bytes made, " << stored.size()
                                 << " checked in, first difference at " << differ.first - bytes.begin()
                                 << "; run generate_scenes data/scenes if the change is meant";
  }
}

TEST(EnvironmentGenerator, WritesTheCheckedInStudio) {
  EXPECT_TRUE(environments::studioHdr() == fileBytes(kFolder + "../environments/studio.hdr"))
      << "run generate_environments data/environments if the change is meant";
}

// White paper that faces the camera of a fitted object is bright, not burnt out, at an exposure of 1.
TEST(EnvironmentGenerator, TheStudioLightsWhatFacesTheCamera) {
  const ImageRgbaF studio = loadHdrImage(kFolder + "../environments/studio.hdr");
  ASSERT_EQ(studio.width, 2 * studio.height);
  const auto whitePaper = [&](const glm::dvec3& normal) {
    double sum = 0.0;
    for (int row = 0; row < studio.height; ++row) {
      const double latitude = M_PI * (0.5 - (row + 0.5) / studio.height);
      for (int column = 0; column < studio.width; ++column) {
        const double longitude = 2.0 * M_PI * (0.5 - (column + 0.5) / studio.width);
        const glm::dvec3 from(std::sin(longitude) * std::cos(latitude), std::sin(latitude),
                              std::cos(longitude) * std::cos(latitude));
        const double cosine = std::max(0.0, glm::dot(from, normal));
        const std::size_t at = 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(studio.width) +
                                    static_cast<std::size_t>(column));
        sum += cosine * std::cos(latitude) * studio.pixels[at + 1];
      }
    }
    return sum * 2.0 * M_PI / studio.width / studio.height;  // irradiance over pi
  };
  const double towardsCamera = whitePaper(glm::normalize(glm::dvec3(0.53, 0.31, 0.85)));
  EXPECT_GT(towardsCamera, 0.6);
  EXPECT_LT(towardsCamera, 1.0);
  EXPECT_GT(whitePaper({0, 0, 1}), 1.5 * whitePaper({0, 0, -1})) << "key against rim";
  EXPECT_GT(whitePaper({0, -1, 0}), 0.1) << "undersides are not black";
}

TEST(SceneGenerator, SkyPictureIsTheSkyOfTheBuilding) {
  const Scene scene = loadSceneFile(kFolder + "building.boxprobe.json");
  const auto& sky = std::get<SkyGradient>(scene.sky);
  const ImageRgbaF picture = loadHdrImage(kFolder + "sky.hdr");
  ASSERT_EQ(picture.width, 2 * picture.height);
  for (int row = 0; row < picture.height; ++row) {
    const double elevation = M_PI * (0.5 - (row + 0.5) / picture.height);
    const glm::vec3 direction(0.0f, std::sin(elevation), std::cos(elevation));
    const glm::vec3 expected = shading::skyGradient(direction, sky.top, sky.horizon, sky.ground);
    for (int channel = 0; channel < 3; ++channel)  // RGBE keeps 8 bits below the brightest channel
      EXPECT_NEAR(picture.pixels[static_cast<std::size_t>(row * picture.width * 4 + channel)], expected[channel],
                  1.0 / 128.0);
  }
}

TEST(Building, ProbeBoxIsTheInnerSpaceWithAHairOfRoom) {
  const Scene scene = loadSceneFile(kFolder + "building.boxprobe.json");
  ASSERT_EQ(scene.probes.size(), 1u);
  const Probe& probe = scene.probes.front();
  EXPECT_EQ(probe.name, "room");
  EXPECT_EQ(probe.box.min, glm::dvec3(-4.505, -0.005, -4.505));
  EXPECT_EQ(probe.box.max, glm::dvec3(4.505, 5.005, 4.505));
  EXPECT_EQ(probe.bounces, 2);
}

TEST(Building, OnlySpheresStandInTheInnerSpaceAndWallsLieInItsPlanes) {
  const Model model = loadModelFile(kFolder + "building.glb");
  const glm::dvec3 low(-4.5, 0.0, -4.5), high(4.5, 5.0, 4.5);
  std::map<std::string, std::array<bool, 6>> touches;  // -x +x -y +y -z +z
  for (const Triangle& t : triangles(model)) {
    if (startsWith(t.node, "sphere")) continue;
    glm::dvec3 least = t.corners[0], most = t.corners[0];
    for (const glm::dvec3& corner : t.corners) least = glm::min(least, corner), most = glm::max(most, corner);
    bool apart = false;  // some plane of the inner space has the whole triangle behind it
    std::size_t plane = 0;
    for (int axis = 0; axis < 3; ++axis, plane += 2) {
      apart = apart || most[axis] <= low[axis] || least[axis] >= high[axis];
      if (most[axis] == low[axis]) touches[t.node][plane] = true;
      if (least[axis] == high[axis]) touches[t.node][plane + 1] = true;
    }
    ASSERT_TRUE(apart) << t.node << " reaches into the inner space";
  }
  for (const char* node : {"pillars", "plinths and copings", "screens", "parapets", "beams"})
    for (std::size_t plane : {0u, 1u, 4u, 5u}) EXPECT_TRUE(touches[node][plane]) << node << ", plane " << plane;
  EXPECT_TRUE(touches["rafters"][3]);
  EXPECT_TRUE(touches["mirror"][2]);
}

TEST(Building, MirrorCoversTheWholeFloorAndTheProbeSeesIt) {
  const Scene scene = loadSceneFile(kFolder + "building.boxprobe.json");
  const Model model = loadModelFile(kFolder + "building.glb");
  double area = 0.0;
  for (const Triangle& t : triangles(model)) {
    if (t.node != "mirror") continue;
    area += glm::length(t.areaVector());
    for (int k = 0; k < 3; ++k) EXPECT_EQ(t.normals[static_cast<std::size_t>(k)], glm::dvec3(0, 1, 0));
    EXPECT_EQ(t.material, "mirror");
    EXPECT_EQ(t.surface->roughness, 0.0f);
    EXPECT_EQ(t.surface->metallic, 1.0f);
  }
  EXPECT_DOUBLE_EQ(area, 81.0);
  const auto entry = scene.objects.find("mirror");
  EXPECT_TRUE(entry == scene.objects.end() || entry->second.seenByProbes);
}

TEST(Building, EightSpheresNearTheEdgesAndOneNearTheMiddle) {
  const Model model = loadModelFile(kFolder + "building.glb");
  int nearEdge = 0, nearMiddle = 0;
  for (const Instance& instance : model.instances) {
    if (!startsWith(instance.node, "sphere")) continue;
    const glm::dvec3 center(instance.worldFromModel[3]);
    const double fromMiddle = std::max(std::abs(center.x), std::abs(center.z));
    EXPECT_LE(fromMiddle + 0.5, 4.5) << instance.node;
    nearEdge += fromMiddle > 3.0;
    nearMiddle += fromMiddle < 1.0;
  }
  EXPECT_EQ(nearEdge, 8);
  EXPECT_EQ(nearMiddle, 1);
}

TEST(Building, LightsAreAllDirectional) {  // the renderer takes directional lights for positional ones beside those
  for (const Light& light : loadSceneFile(kFolder + "building.boxprobe.json").lights)
    EXPECT_EQ(light.type, LightType::Directional);
}

}  // namespace
}  // namespace boxprobe
