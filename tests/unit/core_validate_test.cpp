// Every range of a scene, each broken alone: the message must name the key and say what to do.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "filters/core/base/field_error.h"
#include "filters/core/base/number_text.h"
#include "filters/core/scene/scene.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kNanFloat = std::numeric_limits<float>::quiet_NaN();

/// A scene with one of everything, sound.
Scene soundScene() {
  Scene scene;
  scene.models.push_back({"building.glb", {}, {}, 1.0});
  scene.cameras.emplace_back();
  scene.lights.resize(2);
  scene.lights[1].type = LightType::Point;
  scene.materials["floor"] = MaterialOverride();
  scene.objects["mirror"] = ObjectOverride();
  scene.probes.resize(2);
  scene.probes[0].name = "room";
  scene.probes[1].name = "hall";
  return scene;
}

std::string problem(const std::function<void(Scene&)>& edit) {
  Scene scene = soundScene();
  edit(scene);
  return errorText<FieldError>([&] { validate(scene); });
}

void expectSound(const std::function<void(Scene&)>& edit) {
  Scene scene = soundScene();
  edit(scene);
  EXPECT_NO_THROW(validate(scene));
}

TEST(Validate, SoundScenesPass) {
  EXPECT_NO_THROW(validate(Scene()));
  EXPECT_NO_THROW(validate(soundScene()));
}

TEST(Validate, InvertedBoxNamesTheAxisAndBothValues) {
  EXPECT_EQ(problem([](Scene& s) {
              s.probes[0].box = {{3, 0, 0}, {1, 1, 1}};
            }),
            "probes.room.box: min.x 3 is greater than max.x 1; swap them");
  EXPECT_EQ(problem([](Scene& s) {
              s.probes[1].influence = Box{{0, 0.5, 0}, {1, 0.25, 1}};
            }),
            "probes.hall.influence: min.y 0.5 is greater than max.y 0.25; swap them");
  expectSound([](Scene& s) { s.probes[0].box = {{1, 0, 0}, {1, 1, 1}}; });  // flat is a lesson, not an error
}

TEST(Validate, NonFiniteNumbersAreRefusedEverywhere) {
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].origin.y = kNan; }), "probes.room.origin: y is not a finite number");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].box.max.z = kInfinity; }),
            "probes.room.box.max: z is not a finite number");
  EXPECT_EQ(problem([](Scene& s) { s.cameras[0].position.x = kNan; }),
            "cameras.main.position: x is not a finite number");
  EXPECT_EQ(problem([](Scene& s) { s.lights[1].position.x = kNan; }), "lights[1].position: x is not a finite number");
  EXPECT_EQ(problem([](Scene& s) { s.models[0].translation.x = kNan; }),
            "models[0].translation: x is not a finite number");
  EXPECT_EQ(problem([](Scene& s) { s.exposure = kNan; }), "exposure: is not a finite number");
  const std::vector<std::function<void(Scene&)>> rest = {
      [](Scene& s) { s.models[0].rotationDegrees.x = kInfinity; },
      [](Scene& s) { s.models[0].scale = kNan; },
      [](Scene& s) { s.sky = SkyColor{glm::vec3(kNanFloat)}; },
      [](Scene& s) {
        s.sky = SkyGradient{glm::vec3(kNanFloat), {}, {}};
      },
      [](Scene& s) { s.cameras[0].target.z = kInfinity; },
      [](Scene& s) { s.cameras[0].up.z = kNan; },
      [](Scene& s) { s.cameras[0].verticalFovDegrees = kNan; },
      [](Scene& s) { s.lights[0].direction.x = kNan; },
      [](Scene& s) { s.lights[0].color.x = kNanFloat; },
      [](Scene& s) { s.lights[0].intensity = kNanFloat; },
      [](Scene& s) { s.lights[0].angleDegrees = kNan; },
      [](Scene& s) { s.lights[0].angleDegrees = 100.0; },
      [](Scene& s) { s.lights[0].radius = -1.0; },
      [](Scene& s) { s.lights[0].levelsPerUnit = -1.0; },
      [](Scene& s) { s.skyRotationDegrees = kNan; },
      [](Scene& s) { s.materials["floor"].baseColor = glm::vec3(kNanFloat); },
      [](Scene& s) { s.materials["floor"].metallic = kNanFloat; },
      [](Scene& s) { s.materials["floor"].roughness = kNanFloat; },
      [](Scene& s) { s.materials["floor"].emissive = glm::vec3(kNanFloat); },
      [](Scene& s) { s.materials["floor"].normalScale = kNanFloat; },
      [](Scene& s) { s.materials["floor"].coat = kNanFloat; },
      [](Scene& s) { s.materials["floor"].ior = kNanFloat; },
      [](Scene& s) { s.materials["floor"].transmission = kNanFloat; },
      [](Scene& s) { s.materials["floor"].thickness = kNanFloat; },
      [](Scene& s) { s.materials["floor"].attenuationDistance = kNanFloat; },
      [](Scene& s) { s.materials["floor"].attenuationColor = glm::vec3(kNanFloat); },
      [](Scene& s) { s.probes[0].rotationDegrees.x = kNan; },
      [](Scene& s) {
        s.probes[0].influence = Box{{kNan, 0, 0}, {1, 1, 1}};
      },
      [](Scene& s) { s.probes[0].nearDistance = kNan; },
      [](Scene& s) { s.probes[0].farDistance = kInfinity; },
      [](Scene& s) { s.probes[0].clear = glm::vec3(kNanFloat); },
      [](Scene& s) { s.probes[0].blendDistance.max.x = kNan; },
      [](Scene& s) { s.probes[0].importance = kNan; },
      [](Scene& s) { s.probes[0].intensity = kInfinity; },
      [](Scene& s) { s.probes[0].parameters["power"] = kNan; },
      [](Scene& s) {
        s.probes[0].bevel = Bevel{kNan, 0.0};
      },
      [](Scene& s) {
        s.probes[0].occlusion = BoxOcclusion{kNan, 1.0, 1.0};
      },
      [](Scene& s) {
        s.probes[0].lattice = ProbeLattice{true, kNan};
      },
  };
  for (std::size_t i = 0; i < rest.size(); ++i) EXPECT_NE(problem(rest[i]), "") << "case " << i;
}

TEST(Validate, RangesNameTheKeyTheValueAndTheRange) {
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].faceSize = 100; }),
            "probes.room.faceSize: is 100 and must be a power of two from 16 to 2048");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].faceSize = 8; }), "");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].faceSize = 4096; }), "");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].faceSize = std::numeric_limits<int>::min(); }), "");
  expectSound([](Scene& s) { s.probes[0].faceSize = 2048; });
  expectSound([](Scene& s) { s.probes[0].faceSize = 16; });
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].filterSamples = 1000; }),
            "probes.room.filterSamples: is 1000 and must be from 8 to 768");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].samplesPerPixel = 2; }),
            "probes.room.samplesPerPixel: is 2 and must be 1, 4 or 16");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].bounces = 6; }),
            "probes.room.bounces: is 6 and must be from 1 to 5, or \"all\"");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].bounces = 0; }), "");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].blendDistance.min.y = -0.5; }),
            "probes.room.blendDistance.min: is -0.5 and must be 0 or more");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].nearDistance = 0; }),
            "probes.room.near: is 0 and must be greater than 0");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].farDistance = 0.01; }),
            "probes.room.far: is 0.01 and must be greater than near, 0.01");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].decode = glm::dvec2(0, 1); }),
            "probes.room.decode[0]: is 0 and must be greater than 0");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].decode = glm::dvec2(1e30, 1); }), "");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].decode = glm::dvec2(1, kNan); }), "");
  expectSound([](Scene& s) { s.probes[0].decode = glm::dvec2(5, 0); });
  for (const double spacing : {0.0, -0.5}) {
    EXPECT_EQ(problem([spacing](Scene& s) {
                s.probes[0].lattice = ProbeLattice{true, spacing};
              }),
              "probes.room.lattice.spacing: is " + numberText(spacing) + " and must be greater than 0");
  }
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].intensity = -1; }),
            "probes.room.intensity: is -1 and must be 0 or more");
  EXPECT_EQ(problem([](Scene& s) { s.materials["floor"].roughness = 1.5f; }),
            "materials.floor.roughness: is 1.5 and must be from 0 to 1");
  expectSound([](Scene& s) { s.materials["floor"].ior = 0.75f; });
  for (const float ior : {0.0f, -1.5f}) {
    EXPECT_EQ(problem([ior](Scene& s) { s.materials["floor"].ior = ior; }),
              std::string("materials.floor.ior: is ") + (ior == 0.0f ? "0" : "-1.5") + " and must be greater than 0");
  }
  EXPECT_EQ(problem([](Scene& s) { s.materials["floor"].attenuationColor = glm::vec3(0.5f, 2.0f, 0.0f); }),
            "materials.floor.attenuationColor: is 2 and must be from 0 to 1");
  EXPECT_EQ(problem([](Scene& s) { s.materials["floor"].thickness = -1.0f; }),
            "materials.floor.thickness: is -1 and must be 0 or more");
  EXPECT_EQ(problem([](Scene& s) { s.cameras[0].verticalFovDegrees = 180; }),
            "cameras.main.verticalFovDegrees: is 180 and must be greater than 0 and less than 180");
  EXPECT_EQ(problem([](Scene& s) { s.lights[0].intensity = -2; }), "lights[0].intensity: is -2 and must be 0 or more");
  EXPECT_EQ(problem([](Scene& s) { s.models[0].scale = 0; }), "models[0].scale: is 0 and must be greater than 0");
  EXPECT_EQ(problem([](Scene& s) { s.exposure = -1; }), "exposure: is -1 and must be from 0 to 1e+12");
  EXPECT_NE(problem([](Scene& s) { s.sky = SkyColor{{0, -1, 0}}; }), "");
}

TEST(Validate, DirectionsMustPointSomewhere) {
  EXPECT_EQ(problem([](Scene& s) { s.cameras[0].target = s.cameras[0].position; }),
            "cameras.main.target: is the camera's own position; move one of them");
  EXPECT_NE(problem([](Scene& s) { s.cameras[0].up = glm::dvec3(0.0); }), "");
  EXPECT_EQ(problem([](Scene& s) { s.cameras[0].up = s.cameras[0].target - s.cameras[0].position; }),
            "cameras.main.up: is parallel to the view direction; turn one of them");
  EXPECT_NE(problem([](Scene& s) { s.lights[0].direction = glm::dvec3(0.0); }), "");
}

TEST(Validate, NamesAreThereAndUnique) {
  EXPECT_EQ(problem([](Scene& s) { s.probes[1].name = ""; }), "probes[1].name: is empty; give it a name");
  EXPECT_EQ(problem([](Scene& s) { s.probes[1].name = "room"; }),
            "probes[1].name: \"room\" is already the name of probes[0]; give each its own");
  EXPECT_NE(problem([](Scene& s) { s.probes[1].name = "two\nlines"; }), "");
  EXPECT_NE(problem([](Scene& s) { s.cameras.emplace_back(); }), "");  // a second "main"
  EXPECT_NE(problem([](Scene& s) { s.models[0].file = ""; }), "");
  EXPECT_NE(problem([](Scene& s) { s.sky = SkyImage{}; }), "");
}

TEST(Validate, MessagesStayOneLineWhateverNamesHold) {
  EXPECT_NE(problem([](Scene& s) { s.materials["two\nlines"].roughness = 2.0f; }), "");
  EXPECT_NE(problem([](Scene& s) { s.probes[0].technique = "two\nlines"; }), "");
}

TEST(Validate, UnknownTechniqueListsTheKnownOnes) {
  const std::string text = problem([](Scene& s) { s.probes[0].technique = "boxx"; });
  EXPECT_EQ(text.rfind("probes.room.technique: \"boxx\" is not known; use PROJECTION, EVALUATION", 0), 0u) << text;
  for (const char* id : {"infinite", "sphere", "box", "none"}) EXPECT_NE(text.find(id), std::string::npos) << id;
}

TEST(Validate, ParametersHaveNamesKindsAndRanges) {
  expectSound([](Scene& s) {
    s.probes[0].parameters = {{"samples", 64.0}, {"pattern", std::string("blue")}, {"animated", true}, {"power", 2.5}};
  });
  const std::string unknown = problem([](Scene& s) { s.probes[0].parameters["sample"] = 4.0; });
  EXPECT_NE(unknown.find("probes.room.parameters.sample: "), std::string::npos);
  EXPECT_NE(unknown.find("did you mean \"samples\"?"), std::string::npos);
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].parameters["samples"] = 2.5; }),
            "probes.room.parameters.samples: must be a whole number from 1 to 256");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].parameters["animated"] = 1.0; }),
            "probes.room.parameters.animated: must be true or false");
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].parameters["sampling"] = std::string("random"); }),
            "probes.room.parameters.sampling: must be one of \"ggx\", \"luminance\"");
}

TEST(Validate, CustomModeNeedsAnImage) {
  EXPECT_EQ(problem([](Scene& s) { s.probes[0].mode = ProbeMode::Custom; }),
            "probes.room.image: is missing; mode \"custom\" needs an image file");
}

TEST(Validate, TenThousandProbesAreTheMost) {
  Scene scene;
  for (int i = 0; i < 10000; ++i) {
    scene.probes.emplace_back();
    scene.probes.back().name = "p" + std::to_string(i);
  }
  EXPECT_NO_THROW(validate(scene));
  scene.probes.emplace_back();
  EXPECT_EQ(errorText([&] { validate(scene); }), "probes: has 10001 entries; at most 10000 are allowed");
}

}  // namespace
}  // namespace boxprobe
