// Every kind of measure, every published form and a task for the page, in a room where nothing is symmetrical: against
// lesson_measures.txt and published_forms.txt.
#include <gtest/gtest.h>
#include <vtkOpenGLRenderWindow.h>

#include <nlohmann/json.hpp>

#include "app/lessons/lesson_player.h"
#include "app/lessons/published_picture.h"
#include "filters/core/base/errors.h"
#include "tests/image/quad_world.h"
#include "tests/support/kept_values.h"

namespace boxprobe::test {
namespace {

// Of light from pictures, another driver's last digits.
constexpr double kTolerance = 4e-3;

Material painted(const glm::vec3& color, float metallic, float roughness) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = metallic;
  material.roughness = roughness;
  material.doubleSided = true;
  return material;
}

struct OddRoom {
  OddRoom() {
    Model model;
    addSquare(model, "floor", {0.4f, 0.0f, 0.2f}, {2.6f, 0, 0}, {0, 0, -2.2f}, painted({0.8f, 0.7f, 0.5f}, 1.0f, 0.2f));
    addSquare(model, "back", {0.4f, 1.3f, -2.0f}, {2.6f, 0, 0}, {0, 1.3f, 0}, painted({0.7f, 0.2f, 0.1f}, 0.0f, 0.7f));
    addSquare(model, "left", {-2.2f, 1.3f, 0.2f}, {0, 0, -2.2f}, {0, 1.3f, 0}, glowing({0.2f, 0.7f, 1.1f}));
    addSquare(model, "right", {3.0f, 1.3f, 0.2f}, {0, 0, 2.2f}, {0, 1.3f, 0}, painted({0.2f, 0.6f, 0.3f}, 0.4f, 0.35f));
    addSquare(model, "ceiling", {0.4f, 2.6f, -0.4f}, {2.6f, 0, 0}, {0, 0, 1.6f}, glowing({0.9f, 0.5f, 0.3f}));
    models = {std::make_shared<const Model>(std::move(model))};
    scene = darkScene();
    scene.sky = SkyGradient{{0.1f, 0.3f, 0.9f}, {0.6f, 0.5f, 0.4f}, {0.2f, 0.1f, 0.05f}};
    scene.models.push_back({"room", {}, {}});
    scene.lamps = LampForm::InMap;
    scene.exposure = 1.25;
    Probe probe = cubeProbe("room", {0.9, 1.1, -0.3}, 1.0, 32);
    probe.box = {{-2.2, 0.0, -2.0}, {3.0, 2.6, 2.4}};
    probe.influence = Box{{-2.3, -0.1, -2.1}, {3.1, 2.7, 2.5}};
    probe.intensity = 0.9;
    scene.probes = {probe};
    camera.position = {0.3, 1.7, 2.1};
    camera.target = {0.6, 0.6, -1.5};
    camera.verticalFovDegrees = 62.0;
    scene.cameras = {camera};
  }
  Scene scene;
  std::vector<std::shared_ptr<const Model>> models;
  Camera camera;
};

class LessonValues : public testing::Test {
 protected:
  LessonValues() : shown_({"this test", 64, 40, 1, true, false, Offscreen::Automatic, true}) {
    shown_.show(room_.scene, room_.models, {room_.camera});
    shown_.capture();
    shown_.requireHealthy();
  }
  ShownScene shown() { return {shown_.renderer(), room_.scene, room_.models, room_.camera, 64, 40}; }
  static LessonMeasure measureOf(MeasureKind kind, const PictureRegion& region = {0.1, 0.55, 0.7, 0.95},
                                 const std::string& name = "") {
    LessonMeasure measure;
    measure.kind = kind;
    measure.region = region;
    measure.name = name;
    return measure;
  }
  void add(const std::string& name, const LessonMeasure& measure) {
    const auto value = measureShown(shown(), measure);
    values_.add(name + (value ? "" : " is not defined"), std::vector<double>{value.value_or(0.0)});
  }
  /// Means of blocks, in a few lines.
  void add(const std::string& name, const ImageRgbaF& picture) {
    constexpr int kBlock = 4;
    for (int y = 0; y + kBlock <= picture.height; y += kBlock) {
      std::vector<double> means;
      for (int x = 0; x + kBlock <= picture.width; x += kBlock) {
        for (std::size_t c = 0; c < 3; ++c) {
          double sum = 0.0;
          for (int i = 0; i < kBlock * kBlock; ++i) {
            sum += picture.pixels[4 * static_cast<std::size_t>((y + i / kBlock) * picture.width + x + i % kBlock) + c];
          }
          means.push_back(std::round(sum / (kBlock * kBlock) * 1e4) / 1e4);
        }
      }
      values_.add(name + " row " + std::to_string(y), means);
    }
  }

  OddRoom room_;
  OffscreenScene shown_;
  test::KeptValues values_;
};

TEST_F(LessonValues, MeasuresAreThoseOfTheFile) {
  values_.part("light");
  for (const PictureRegion& region : {PictureRegion{0.0, 0.0, 1.0, 1.0}, PictureRegion{0.1, 0.55, 0.7, 0.95},
                                      PictureRegion{0.6, 0.2, 0.6, 0.2}, PictureRegion{1.0, 1.0, 1.0, 1.0}}) {
    LessonMeasure mean = measureOf(MeasureKind::Mean, region);
    for (mean.channel = -1; mean.channel < 3; ++mean.channel) add("mean of " + std::to_string(mean.channel), mean);
    add("jump", measureOf(MeasureKind::Jump, region));
  }
  values_.part("errors");
  const PictureRegion floor{0.2, 0.6, 0.5, 0.8};
  LessonMeasure error = measureOf(MeasureKind::Error, floor);
  add("from the scene", error);
  error.box = true;
  add("from the box", error);
  values_.part("views and explanations");
  for (const char* view : {"level", "hit-error", "direction-error", "roughness", "weight", "nonsense"}) {
    LessonMeasure measure = measureOf(MeasureKind::View, floor, view);
    add(view, measure);
    measure.points = {{0.45, 0.8}};
    add(std::string(view) + " at a point", measure);
  }
  for (const char* name : {"/probes/0/hitDistance", "/probes/0/slabFactors/0", "/probes/0/slabFactors/2",
                           "/surface/nDotV", "/color/1", "/probes/7/weight", "/notes", "nothing"}) {
    LessonMeasure measure = measureOf(MeasureKind::Explain, {0.0, 0.3, 0.9, 0.9}, name);
    add(name, measure);
    measure.points = {{0.65, 0.999}, {0.1, 0.1}};
    add(std::string(name) + " at a point", measure);
  }
  values_.part("a line's image");
  LessonMeasure bend = measureOf(MeasureKind::Bend);
  room_.scene.probes[0].box.max.x = 2.4;
  shown_.show(room_.scene, room_.models, {room_.camera});
  bend.points = {{0.2, 0.8}, {0.5, 0.8}, {0.9, 0.85}};
  add("bent", bend);
  bend.points = {{0.2, 0.8}, {0.5, 0.8}, {0.2, 0.8}};
  add("of no length", bend);
  bend.points = {{0.2, 0.8}, {0.5, 0.1}, {0.9, 0.85}};
  add("not on the floor", bend);
  values_.part("fields and fits");
  add("field", measureOf(MeasureKind::Field, floor, "probes.room.box.max[0]"));
  add("no field", measureOf(MeasureKind::Field, floor, "probes.hall.box.max[0]"));
  add("fit", measureOf(MeasureKind::Fit, floor, "/probes/0/box/max/0"));
  values_.part("of another picture");
  ImageRgbaF other{64, 40, {}};
  for (int i = 0; i < 64 * 40 * 4; ++i) other.pixels.push_back(0.001f * static_cast<float>(i * 7 % 1999));
  ShownScene given = shown();
  given.picture = &other;
  for (const MeasureKind kind : {MeasureKind::Mean, MeasureKind::Jump, MeasureKind::Error}) {
    values_.add("given", std::vector<double>{measureShown(given, measureOf(kind, floor)).value_or(-1.0)});
  }
  // What was shown before is shown again.
  Camera elsewhere = room_.camera;
  elsewhere.position.x = -1.0;
  shown_.renderer().applyCamera(elsewhere);
  shown_.renderer().setView({3, {}, {}});
  add("from the lesson's camera", measureOf(MeasureKind::Mean));
  EXPECT_NEAR(shown_.renderer().currentCamera().position.x, -1.0, 1e-9);
  EXPECT_EQ(shown_.renderer().view().view, 3);
  EXPECT_EQ(explanationsOf(shown(), measureOf(MeasureKind::View)).size(), 640u);
  EXPECT_NEAR(shown_.renderer().currentCamera().position.x, -1.0, 1e-9);
  values_.expect("image/values/lesson_measures.txt", kTolerance);
}

TEST_F(LessonValues, PublishedFormsAreThoseOfTheFile) {
  for (const std::string_view form : publishedForms()) {
    const std::string id(form);
    EXPECT_TRUE(isPublishedForm(id));
    PublishedPicture picture(shown_.renderer(), room_.scene, id, 24, 16);
    EXPECT_EQ(picture.brokenShare(), 0.0);
    EXPECT_EQ(picture.meanTurn(), 0.0);
    EXPECT_TRUE(picture.draw(7));
    EXPECT_TRUE(picture.draw(7));
    EXPECT_FALSE(picture.draw(7)) << "16 rows";
    EXPECT_FALSE(picture.draw(7));
    values_.part(id);
    values_.add("broken, turned", std::vector<double>{picture.brokenShare(), picture.meanTurn()});
    add("light", picture.linear());
  }
  EXPECT_FALSE(isPublishedForm("own"));
  // On show: twice as large, at the scene's exposure.
  PublishedPicture picture(shown_.renderer(), room_.scene, "select", 24, 16);
  picture.draw(16);
  const ImageRgba8 display = picture.display(2);
  ASSERT_EQ(display.width, 48);
  ASSERT_EQ(display.height, 32);
  int wrong = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      const float* light = &picture.linear().pixels[4 * static_cast<std::size_t>(24 * (y / 2) + x / 2)];
      const auto bytes = displayBytes({light[0], light[1], light[2]}, 1.25, room_.scene.tone);
      const std::uint8_t* shown = &display.pixels[4 * static_cast<std::size_t>(48 * y + x)];
      wrong += std::equal(bytes.begin(), bytes.end(), shown) && shown[3] == 255 ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0);
  values_.expect("image/values/published_forms.txt", kTolerance);
}

}  // namespace
}  // namespace boxprobe::test
