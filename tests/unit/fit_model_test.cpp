// What a bare model is taken for, and what follows: on rooms, things and courts made here.
#include "filters/fit/fit_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "filters/fit/exposure_key.h"
#include "filters/fit/standing_points.h"
#include "tests/support/sphere_mesh.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

const Box kRoom{glm::dvec3(-4, 0, -3), glm::dvec3(4, 2.8, 3)};

Model closedRoom() {
  MadeModel made;
  made.box(kRoom, true);
  return made.model;
}

/// kRoom with a hole of 2 x 1.2 m in its wall at +x.
Model roomWithWindow() {
  MadeModel made;
  for (int axis = 0; axis < 3; ++axis) {
    made.side(kRoom, axis, false);
    if (axis != 0) made.side(kRoom, axis, true);
  }
  const auto wall = [&](double y0, double y1, double z0, double z1) {
    made.side({glm::dvec3(-4, y0, z0), glm::dvec3(4, y1, z1)}, 0, true);
  };
  wall(0, 0.9, -3, 3);
  wall(2.1, 2.8, -3, 3);
  wall(0.9, 2.1, -3, -1);
  wall(0.9, 2.1, 1, 3);
  return made.model;
}

Model court() {
  MadeModel made;
  for (const auto& [axis, upper] : {std::pair(1, false), {0, false}, {0, true}, {2, false}}) {
    made.side({glm::dvec3(-5, 0, -5), glm::dvec3(5, 4, 5)}, axis, upper);
  }
  return made.model;
}

Model ball() {
  Model model;
  model.meshes.push_back(test::sphereMesh(1.0f, 24, 48));
  model.instances.push_back({"ball", 0, glm::dmat4(1.0)});
  return model;
}

struct Fitted {
  Scene scene;
  ModelFit fit;
};

Fitted fitted(Model model, const FitWishes& wishes = {}, const ModelFile& file = {"made.glb"}) {
  Fitted result;
  result.scene.models = {file};
  const std::vector<std::shared_ptr<const Model>> models = {std::make_shared<const Model>(std::move(model))};
  result.fit = fitModel(result.scene, models, wishes);
  EXPECT_NO_THROW(validate(result.scene));
  return result;
}

// What is higher than a tenth of the room is furniture, over which nobody stands; what is lower is a step.
TEST(StandingPoints, AStepIsAFloorAndATableIsNot) {
  constexpr double kHeight = 3.0;
  for (const double rise : {0.26, 0.288}) {  // of the 2.74 and 2.712 above them .0949 and .1062
    MadeModel made;
    made.box({glm::dvec3(-3.7, 0, -2.9), glm::dvec3(4.1, kHeight, 3.3)}, true);
    made.box({glm::dvec3(-3.7, 0, -2.9), glm::dvec3(-0.9, rise, 3.3)}, false);
    Scene scene;
    scene.models = {{"made.glb"}};
    const TriangleRays rays(scene, {std::make_shared<const Model>(std::move(made.model))});
    const std::vector<StandingPoint> points = standingPoints(rays, surveyModel(rays));
    int raised = 0, low = 0;
    for (const StandingPoint& point : points) {
      if (std::abs(point.floor - rise) < 1e-6) ++raised;
      if (std::abs(point.floor) < 1e-6) ++low;
    }
    EXPECT_EQ(static_cast<std::size_t>(raised + low), points.size());
    EXPECT_GT(low, 10);
    if (rise < 0.27) {
      EXPECT_GT(raised, 5);
    } else {
      EXPECT_EQ(raised, 0);
    }
  }
}

// Two storeys with stairs between them: half of all floors are below a step and half above, and nobody opens a house on
// its stairs.
TEST(StandingPoints, NobodyStandsOnTheStairsOfTwoStoreys) {
  constexpr double kUpper = 3.1;
  MadeModel made;
  const Box house{glm::dvec3(-5.2, 0, -3.9), glm::dvec3(4.3, 6.3, 3.6)};
  made.box(house, true);
  // The upper floor, with a stairwell at +x: both of its sides.
  const auto slab = [&](double x0, double x1, double z0, double z1) {
    made.box({glm::dvec3(x0, kUpper - 0.2, z0), glm::dvec3(x1, kUpper, z1)}, false);
  };
  slab(-5.2, 2.1, -3.9, 3.6);
  slab(2.1, 4.3, 2.9, 3.6);
  for (int step = 0; step < 10; ++step) {
    const double z = -3.9 + 0.68 * step;
    made.box({glm::dvec3(2.1, 0.0, z), glm::dvec3(4.3, 0.31 * (step + 1), z + 0.68)}, false);
  }
  Scene scene;
  scene.models = {{"made.glb"}};
  const TriangleRays rays(scene, {std::make_shared<const Model>(std::move(made.model))});
  const std::vector<StandingPoint> points = standingPoints(rays, surveyModel(rays));
  ASSERT_FALSE(points.empty());
  const double floor = points.front().floor;
  EXPECT_TRUE(std::abs(floor) < 1e-6 || std::abs(floor - kUpper) < 1e-6) << floor;
}

TEST(ModelKind, ABoxSeenFromWithinIsAnInterior) {
  const Fitted room = fitted(closedRoom());
  EXPECT_EQ(room.fit.kind, ModelKind::Interior) << room.fit.decided.english();
  EXPECT_EQ(fitted(roomWithWindow()).fit.kind, ModelKind::Interior);
}

TEST(ModelKind, ABallAndACrateAreObjects) {
  EXPECT_EQ(fitted(ball()).fit.kind, ModelKind::Object);
  MadeModel crate;
  crate.box(kRoom, false);
  EXPECT_EQ(fitted(crate.model).fit.kind, ModelKind::Object);
  Model twoSided = crate.model;
  twoSided.materials.emplace_back().doubleSided = true;
  twoSided.meshes.front().material = 0;
  EXPECT_EQ(fitted(twoSided).fit.kind, ModelKind::Object) << "the sides count, not whether both are drawn";
}

TEST(ModelKind, AFloorWithThreeWallsIsOpenAndSoIsAPlainWithAThing) {
  EXPECT_EQ(fitted(court()).fit.kind, ModelKind::Open);
  MadeModel plain;
  plain.side({glm::dvec3(-10, 0, -10), glm::dvec3(10, 2, 10)}, 1, false);
  plain.box({glm::dvec3(-1, 0, -1), glm::dvec3(1, 2, 1)}, false);
  EXPECT_EQ(fitted(plain.model).fit.kind, ModelKind::Open);
}

// Between two things that stand apart most rays from outside meet nothing, and those say nothing of sides.
TEST(ModelKind, OfTwoThingsApartOnlyRaysThatMeetOneCount) {
  for (const bool fromWithin : {false, true}) {
    MadeModel made;
    made.box({glm::dvec3(-9, 0, -3), glm::dvec3(-5, 2.8, 1)}, fromWithin);
    made.box({glm::dvec3(6, 0.5, 0), glm::dvec3(9, 3.1, 4)}, fromWithin);
    EXPECT_EQ(fitted(made.model).fit.survey.backOutside, fromWithin ? 1.0 : 0.0);
  }
}

TEST(ModelKind, AMirroredInstanceKeepsItsFronts) {
  Model model = closedRoom();
  model.instances.front().worldFromModel = glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
  std::vector<std::uint32_t>& indices = model.meshes.front().indices;  // as readers turn them over for such an instance
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
  EXPECT_EQ(fitted(model).fit.kind, ModelKind::Interior);
}

TEST(ModelKind, ACupIsAnObjectHoweverHollow) {
  ModelFile file{"cup.glb"};
  file.scale = 0.02;
  EXPECT_EQ(fitted(court(), {}, file).fit.kind, ModelKind::Object);
}

TEST(ModelKind, ADomeWithASkyIsNotAWall) {
  Model model = closedRoom();
  MadeModel dome;
  dome.box({glm::dvec3(-100), glm::dvec3(100)}, true);
  model.meshes.push_back(dome.model.meshes.front());
  model.instances.push_back({"Sky.001", 1, glm::dmat4(1.0)});
  const Fitted room = fitted(model);
  EXPECT_EQ(room.fit.kind, ModelKind::Interior);
  EXPECT_TRUE(room.fit.warnings.empty()) << "nor the size of the model";
  EXPECT_NEAR(room.scene.probes.at(0).box.max.x, 4.0, 0.05);
}

TEST(ModelKind, ModelsWithoutSurfacesAreObjects) {
  EXPECT_EQ(fitted(Model{}).fit.kind, ModelKind::Object);
  Model flat = closedRoom();
  flat.instances.front().worldFromModel = glm::scale(glm::dmat4(1.0), glm::dvec3(0.0));
  EXPECT_EQ(fitted(flat).fit.kind, ModelKind::Object);
  Model broken = closedRoom();
  broken.meshes.front().positions[3].x = std::nanf("");
  EXPECT_EQ(fitted(broken).fit.kind, ModelKind::Interior);
}

TEST(FitModel, AnObjectHasNoProbeAndAStudio) {
  FitWishes wishes;
  wishes.studio = "studio.hdr";
  const Fitted thing = fitted(ball(), wishes);
  EXPECT_TRUE(thing.scene.probes.empty());
  ASSERT_TRUE(std::holds_alternative<SkyImage>(thing.scene.sky));
  EXPECT_EQ(std::get<SkyImage>(thing.scene.sky).file, "studio.hdr");
  EXPECT_TRUE(thing.fit.lightKnown);
}

TEST(FitModel, TheProbeOfARoomHasItsWallsAndACameraWithin) {
  Model model = closedRoom();
  MadeModel chest;  // does not move the wall it stands at
  chest.box({glm::dvec3(-4, 0, -1), glm::dvec3(-3.2, 1.0, 1)}, false);
  model.meshes.push_back(chest.model.meshes.front());
  model.instances.push_back({"chest", 1, glm::dmat4(1.0)});
  const Fitted room = fitted(model);
  ASSERT_EQ(room.scene.probes.size(), 1u);
  const Probe& probe = room.scene.probes.front();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(probe.box.min[axis], kRoom.min[axis], 0.02) << axis;
    EXPECT_NEAR(probe.box.max[axis], kRoom.max[axis], 0.02) << axis;
  }
  EXPECT_NEAR(probe.origin.y, 1.6, 0.1);
  EXPECT_LT(glm::length(glm::dvec2(probe.origin.x, probe.origin.z)), 2.0);
  const Camera& camera = room.scene.cameras.front();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(camera.position[axis], kRoom.min[axis]);
    EXPECT_LT(camera.position[axis], kRoom.max[axis]);
  }
  EXPECT_NEAR(camera.position.y, 1.6, 0.1);
}

TEST(FitModel, WithoutLightAClosedRoomHasLampsAndAnOpenOneItsOpenings) {
  const Fitted closed = fitted(closedRoom());
  EXPECT_EQ(closed.fit.light, FitLight::Ceiling);
  ASSERT_FALSE(closed.scene.lights.empty());
  for (const Light& lamp : closed.scene.lights) {
    EXPECT_GT(lamp.position.y, 1.8);
    EXPECT_LT(lamp.position.y, 2.8);
  }
  const Fitted open = fitted(roomWithWindow());
  EXPECT_EQ(open.fit.light, FitLight::Openings);
  ASSERT_EQ(open.scene.lights.size(), 1u);
  const Light& window = open.scene.lights.front();
  EXPECT_GT(window.position.x, 4.0) << "outside";
  EXPECT_LT(window.direction.x, 0.0) << "shines in";
  EXPECT_NEAR(window.position.y, 1.5, 0.2);
  EXPECT_NEAR(window.intensity, 2.4 * 0.9, 0.4) << "area of the window times the sky's radiance";
  Model lit = closedRoom();
  lit.lights.emplace_back();
  EXPECT_EQ(fitted(lit).fit.light, FitLight::File);
}

TEST(FitModel, IsChangedByWishes) {
  FitWishes wishes;
  wishes.kind = ModelKind::Object;
  wishes.light = FitLight::Daylight;
  const Fitted room = fitted(closedRoom(), wishes);
  EXPECT_EQ(room.fit.survey.kind, ModelKind::Interior);
  EXPECT_EQ(room.fit.kind, ModelKind::Object);
  EXPECT_TRUE(room.scene.probes.empty());
  ASSERT_EQ(room.scene.lights.size(), 1u);
  EXPECT_EQ(room.scene.lights.front().type, LightType::Directional);
  wishes.kind = ModelKind::Interior;
  EXPECT_NO_THROW(fitted(ball(), wishes)) << "nobody can stand in it";
}

TEST(FitModel, SaysWhoChoseTheLight) {
  using testing::EndsWith;
  Model lit = closedRoom();
  lit.lights.emplace_back();
  EXPECT_THAT(fitted(lit).fit.decided.english(), EndsWith("the light is the file's"));
  EXPECT_THAT(fitted(ball()).fit.decided.english(), EndsWith("the file has no light: a studio lights it"));
  FitWishes wishes;
  wishes.light = FitLight::Studio;
  EXPECT_THAT(fitted(lit, wishes).fit.decided.english(), EndsWith("as you chose, a studio lights it"));
  wishes.light = FitLight::File;
  EXPECT_THAT(fitted(ball(), wishes).fit.decided.english(),
              EndsWith("the file has no light, and you chose the file's"));
  wishes.light = FitLight::Ceiling;
  EXPECT_THAT(fitted(ball(), wishes).fit.decided.english(),
              EndsWith("there is no room with a ceiling: a studio lights it"));
  wishes.light = FitLight::Openings;
  EXPECT_THAT(fitted(closedRoom(), wishes).fit.decided.english(),
              EndsWith("there are no openings: sky and sun light it"));
}

TEST(FitModel, SaysSizesThatAreUnlikelyInMetres) {
  ModelFile file{"made.glb"};
  file.scale = 1000.0;
  const Fitted large = fitted(closedRoom(), {}, file);
  ASSERT_EQ(large.fit.warnings.size(), 1u);
  EXPECT_EQ(large.fit.warnings.front(), "made.glb: 8000 m wide: is the unit mm? --set models.0.unit=mm");
  file.unit = LengthUnit::Millimetre;
  EXPECT_TRUE(fitted(closedRoom(), {}, file).fit.warnings.empty());
  EXPECT_TRUE(fitted(closedRoom()).fit.warnings.empty());
}

TEST(FitModel, SaysHowToTurnFormatsThatDoNotSayWhatIsUp) {
  for (const char* format : {"stl", "ply"}) {
    ModelFile file{std::string("made.") + format};
    const Fitted made = fitted(ball(), {}, file);
    ASSERT_EQ(made.fit.warnings.size(), 1u);
    EXPECT_EQ(made.fit.warnings.front(),
              file.file + ": " + format +
                  " files do not say which way is up: if it lies on its side, --set models.0.upAxis=z");
    file.upAxis = UpAxis::Z;
    EXPECT_TRUE(fitted(ball(), {}, file).fit.warnings.empty());
  }
}

// A file in millimetres opened as metres: 8 m become 8000, and people are still not at a tenth of the height.
TEST(FitModel, EyesAreHighInRoomsOfUnknownUnit) {
  ModelFile file{"made.glb"};
  file.scale = 1000.0;
  const double eye = fitted(closedRoom(), {}, file).scene.cameras.at(0).position.y;
  EXPECT_GT(eye, 500.0 * kRoom.size().y);
  EXPECT_LT(eye, 700.0 * kRoom.size().y);
}

TEST(FitModel, AnObjectFillsTheHeightAndIsWholeInAnyShapeOfPicture) {
  for (const glm::dvec3& size : {glm::dvec3(1.0), glm::dvec3(0.2, 3.0, 0.2), glm::dvec3(4.0, 1.0, 0.01)}) {
    for (const double aspect : {0.6, 1.0, 16.0 / 9.0}) {
      FitWishes wishes;
      wishes.aspect = aspect;
      MadeModel made;
      made.box({-0.5 * size, 0.5 * size}, false);
      const Camera camera = fitted(made.model, wishes).scene.cameras.front();
      const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
      const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
      const double tangent = std::tan(0.5 * glm::radians(camera.verticalFovDegrees));
      double tall = 0.0, wide = 0.0;
      for (const glm::vec3& corner : made.model.meshes.front().positions) {
        const glm::dvec3 from = glm::dvec3(corner) - camera.position;
        const double depth = glm::dot(from, forward);
        ASSERT_GT(depth, 0.0);
        tall = std::max(tall, std::abs(glm::dot(from, up)) / (tangent * depth));
        wide = std::max(wide, std::abs(glm::dot(from, right)) / (tangent * aspect * depth));
      }
      EXPECT_LE(std::max(tall, wide), 0.95);
      EXPECT_GE(std::max(tall, wide), 0.8) << "size " << size.x << " " << size.y << ", aspect " << aspect;
    }
  }
}

ImageRgbaF picture(float value, float bright, float coverage = 1.0f) {
  ImageRgbaF image{16, 16, {}};
  for (int i = 0; i < 256; ++i) {
    const float v = i % 8 == 0 ? bright : value;
    image.pixels.insert(image.pixels.end(), {v, v, v, coverage});
  }
  return image;
}

TEST(Exposure, BringsTheMedianToGreyAndKeepsWhatIsBright) {
  EXPECT_NEAR(keyedExposure(picture(2000.0f, 3000.0f), false), 0.2 / 2000.0, 1e-6);
  EXPECT_NEAR(keyedExposure(picture(0.001f, 0.001f), false), 200.0, 1.0);
  EXPECT_NEAR(keyedExposure(picture(1.0f, 100.0f), false), 0.0072, 1e-6) << "an eighth of it is bright";
  EXPECT_EQ(keyedExposure(picture(0.0f, 0.0f), false), 1.0);
  EXPECT_EQ(keyedExposure(picture(5.0f, 5.0f, 0.0f), false), 1.0) << "nothing but sky";
  EXPECT_NEAR(keyedExposure(picture(5.0f, 5.0f, 0.0f), true), 0.04, 1e-6);
  EXPECT_EQ(keyedExposure(ImageRgbaF{}, true), 1.0);
  // A tone shows the median as the same grey, and lets more of the light near white.
  for (const Tone tone : {Tone::Neutral, Tone::Agx, Tone::Aces}) {
    const auto median = static_cast<float>(2000.0 * keyedExposure(picture(2000.0f, 2000.0f), false, tone));
    EXPECT_NEAR(toneMapped(glm::vec3(median), tone).y, 0.2, 2e-3);
    EXPECT_GT(keyedExposure(picture(1.0f, 100.0f), false, tone), 0.0072);
  }
}

}  // namespace
}  // namespace boxprobe
