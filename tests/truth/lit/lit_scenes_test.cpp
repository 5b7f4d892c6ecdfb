// The lit scenes' files are what their generator writes, their surfaces are those that both renderers express exactly,
// and every picture of the plan is there, quiet, and told apart from its neighbours.
#include "tests/truth/lit/scenes/lit_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "data/scenes/glb_writer.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/truth/lit/lit_pictures.h"

namespace {

using namespace boxprobe;

const std::string kScenes = LitIndex::folder() + "/scenes/";

const nlohmann::json& plan() {
  static const nlohmann::json json = nlohmann::json::parse(readWholeFile(LitIndex::folder() + "/plan.json"));
  return json;
}

TEST(LitScenes, FilesAreWhatTheGeneratorWrites) {
  const std::string how =
      "; renew it with build/release/tests/truth/lit/scenes/generate_lit_scenes tests/truth/lit/scenes";
  // Converted from another's file: what was converted already is left as it is.
  const Model livingRoom = scenes::litLivingRoom(loadModelFile(kScenes + "living-room.glb"));
  const std::pair<const char*, std::string> files[] = {{"closed.glb", scenes::glbBytes(scenes::litClosed())},
                                                       {"doorway.glb", scenes::glbBytes(scenes::litDoorway())},
                                                       {"window.glb", scenes::glbBytes(scenes::litWindow())},
                                                       {"furniture.glb", scenes::glbBytes(scenes::litFurniture())},
                                                       {"object.glb", scenes::glbBytes(scenes::litObject())},
                                                       {"object-sky.hdr", scenes::litObjectSky()},
                                                       {"cornell-box.glb", scenes::glbBytes(scenes::litCornell())},
                                                       {"living-room.glb", scenes::glbBytes(livingRoom)}};
  for (const auto& [name, bytes] : files) EXPECT_TRUE(readWholeFile(kScenes + name) == bytes) << name << how;
}

TEST(LitScenes, SurfacesAreThoseThatBothSidesExpressExactly) {
  std::size_t metals = 0, interfaces = 0, textured = 0, lamps = 0;
  for (const std::string name : plan()["scenes"]) {
    const Scene scene = loadSceneFile(kScenes + name + ".boxprobe.json");
    EXPECT_EQ(scene.cameras.size(), 2u) << name;
    const Model model = loadModelFile(kScenes + name + ".glb");
    EXPECT_TRUE(model.warnings.empty()) << name;
    EXPECT_TRUE(model.lights.empty()) << name;
    for (const Material& m : model.materials) {
      const std::string where = name + ": " + m.name;
      const bool plain = m.metallic == 0.0f && m.specular == 0.0f && m.finish.specularEdge == 0.0f;
      const bool black = m.metallic == 0.0f && m.baseColor == glm::vec4(0, 0, 0, 1) && m.ior == 1.5f;
      EXPECT_TRUE(plain || m.metallic == 1.0f || black) << where;
      EXPECT_FALSE(m.unlit || m.transmits() || m.finish.hasSheen() || m.coat > 0.0f) << where;
      metals += m.metallic == 1.0f;
      interfaces += black && !plain;
      textured += m.baseColorTexture.image != nullptr;
      lamps += m.emissive != glm::vec3(0.0f);
    }
  }
  EXPECT_GE(metals, 4u);
  EXPECT_GE(interfaces, 2u);
  EXPECT_GE(textured, 5u);
  EXPECT_GE(lamps, 5u);
}

// The plan says what is to be there: a picture that was left out would not be missed by a test of those that are.
TEST(LitScenes, EveryPictureOfThePlanIsThereAndQuiet) {
  const LitIndex index = loadLitIndex();
  std::set<std::tuple<std::string, std::string, std::string>> made;
  double loudest = 0.0;
  for (const LitPicture& picture : index.pictures) {
    EXPECT_NO_THROW(loadLitPicture(index, picture));
    made.emplace(picture.scene, picture.camera, picture.bounceText());
    EXPECT_GT(picture.noise, 0.0) << picture.file << ": two seeds cannot agree exactly";
    EXPECT_LT(picture.noise, 0.01) << picture.file;
    loudest = std::max(loudest, picture.noise);
  }
  std::size_t wanted = 0;
  for (const std::string name : plan()["scenes"]) {
    for (const Camera& camera : loadSceneFile(index.scenePath(name)).cameras) {
      for (const nlohmann::json& bounces : plan()["bounces"]) {
        ++wanted;
        const std::string text = bounces.is_number() ? std::to_string(bounces.get<int>()) : bounces.get<std::string>();
        EXPECT_EQ(made.count({name, camera.name, text}), 1u) << name << ", " << camera.name << ", " << text;
      }
    }
  }
  EXPECT_EQ(made.size(), wanted);
  std::printf("  %zu pictures, relative noise %.4f at most\n", made.size(), loudest);
}

// By hand, so that units are right on both sides: where the camera `lit` looks at the white wall between the rooms, no
// bounce, light by the square of the distance and both cosines.
TEST(LitScenes, APointLightGivesWhatItsIntensitySays) {
  const LitIndex index = loadLitIndex();
  const auto middle = std::find_if(index.pictures.begin(), index.pictures.end(), [](const LitPicture& p) {
    return p.scene == "doorway" && p.camera == "lit" && p.bounces == 0;
  });
  ASSERT_NE(middle, index.pictures.end());
  const ImageRgbaF picture = loadLitPicture(index, *middle);
  const glm::dvec3 eye(4.0, 1.5, 2.2), target(0.3, 0.7, 0.1), light(2.6, 1.75, 0.35), color(1.0, 0.86, 0.66);
  const glm::dvec3 albedo(0.74, 0.75, 0.77);
  const double wall = 0.05, intensity = 7.0;
  const glm::dvec3 point = eye + (target - eye) * ((wall - eye.x) / (target.x - eye.x)), to = light - point;
  const double irradiance = intensity * to.x / std::pow(glm::length(to), 3.0);
  for (int channel = 0; channel < 3; ++channel) {
    double seen = 0.0;
    for (int y : {index.height / 2 - 1, index.height / 2}) {
      for (int x : {index.width / 2 - 1, index.width / 2}) {
        seen += 0.25 * picture.pixels.at(static_cast<std::size_t>(4 * (y * index.width + x) + channel));
      }
    }
    const double expected = irradiance * color[channel] * albedo[channel] / 3.141592653589793;
    EXPECT_NEAR(seen, expected, 0.005 * expected) << channel;
  }
}

ImageRgbaF leftToRight(ImageRgbaF image) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 2; ++x) {
      const auto at = [&](int column) { return image.pixels.begin() + 4 * (y * image.width + column); };
      std::swap_ranges(at(x), at(x) + 4, at(image.width - 1 - x));
    }
  }
  return image;
}

// What is compared tells a right picture from one that lacks a bounce or is turned about.
TEST(LitScenes, TheMeasureTellsPicturesApart) {
  const LitIndex index = loadLitIndex();
  for (const LitPicture& picture : index.pictures) {
    const ImageRgbaF truth = loadLitPicture(index, picture), mirrored = leftToRight(truth);
    EXPECT_EQ(litError(index, picture, truth, truth, truth).relativeRmse, 0.0) << picture.file;
    EXPECT_EQ(litError(index, picture, truth, truth, truth).dimLight, 1.0) << picture.file;
    EXPECT_GT(litError(index, picture, truth, mirrored, mirrored).relativeRmse, 0.1) << picture.file;
    for (const LitPicture& other : index.pictures) {
      if (other.scene != picture.scene || other.camera != picture.camera) continue;
      const auto rank = [](const LitPicture& p) { return p.bounces.value_or(3); };
      if (rank(picture) != rank(other) + 1) continue;
      const ImageRgbaF less = loadLitPicture(index, other);
      const LitError error = litError(index, picture, truth, less, less);
      EXPECT_LT(error.meanLight, 1.0) << picture.file << ": a bounce more is more light";
      EXPECT_LT(error.dimLight, 1.0) << picture.file << ": most of all where it is dark";
      // Under an open sky what comes after the first bounce is a hundredth.
      const double least = picture.scene == "object" && rank(picture) > 1 ? 0.0 : 0.02;
      EXPECT_GT(error.relativeRmse, least) << picture.file;
    }
  }
}

}  // namespace
