// A small lesson played: what its steps cost, how their pictures differ, what its claims, curves and tasks measure.
#include "app/lessons/lesson_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkOpenGLRenderWindow.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "filters/core/base/errors.h"
#include "tests/support/kept_values.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

constexpr const char* kRoom =
    "v -2.2 0 -2\nv 3 0 -2\nv 3 0 2.4\nv -2.2 0 2.4\nv -2.2 2.6 -2\nv 3 2.6 -2\nv 3 2.6 2.4\nv -2.2 2.6 2.4\n"
    "o floor\nusemtl floor\nf 1 4 3 2\no walls\nusemtl walls\nf 1 2 6 5\nf 2 3 7 6\nf 4 1 5 8\no top\nusemtl top\nf 5 "
    "6 7 8\n";
constexpr const char* kMaterials =
    "newmtl floor\nKd 0.7 0.6 0.4\nPm 1\nPr 0.15\nnewmtl walls\nKd 0.3 0.6 0.7\nPm 0\nPr 0.8\nnewmtl top\nKd 0 0 0\n"
    "Ke 0.9 0.6 0.4\nPm 0\nPr 1\n";
constexpr const char* kScene = R"({"format": "boxprobe-scene", "version": 1, "model": "room.obj", "lamps": "in-map",
  "sky": {"top": [0.1, 0.3, 0.9], "horizon": [0.6, 0.5, 0.4], "ground": [0.2, 0.1, 0.05]}, "exposure": 1.25,
  "lights": [{"type": "point", "position": [0.3, 1.9, 0.4], "intensity": 4}],
  "cameras": {"main": {"position": [0.3, 1.7, 2.1], "target": [0.6, 0.3, -1.5], "verticalFovDegrees": 24},
              "other": {"position": [-1.3, 1.5, 1.9], "target": [0.9, 0.4, -1], "verticalFovDegrees": 20}},
  "probes": [{"name": "room", "origin": [0.9, 1.1, -0.3], "box": {"min": [-2.2, 0, -2], "max": [3, 2.6, 2.4]},
    "blendDistance": 0, "faceSize": 32, "samplesPerPixel": 1, "bounces": 2, "technique": "infinite"}]})";

class PlayedLesson : public TemporaryFolder {
 protected:
  PlayedLesson() {
    write("room.obj", std::string("mtllib room.mtl\n") + kRoom);
    write("room.mtl", kMaterials);
    write("room.boxprobe.json", kScene);
    lesson_.path = "a lesson";
    lesson_.scene = file("room.boxprobe.json");
    lesson_.steps.resize(5);
    lesson_.steps[1].assignments = {"probes.room.technique=\"box\""};
    lesson_.steps[1].rays = {{0.4, 0.7}, {0.6, 0.8}};
    lesson_.steps[2].published = "half";
    lesson_.steps[2].assignments = {"probes.room.box.max=[2.6, 2.6, 2.4]"};
    lesson_.steps[3].cameraName = "other";
    lesson_.steps[3].view = "direction-error";
    lesson_.steps[4].assignments = {"probes.room.faceSize=64"};
    lesson_.steps[4].reflections = false;
  }

  static LessonMeasure measureOf(MeasureKind kind, std::optional<std::size_t> step, const std::string& name = "") {
    LessonMeasure measure;
    measure.kind = kind;
    measure.step = step;
    measure.name = name;
    measure.region = {0.2, 0.3, 0.8, 0.9};
    return measure;
  }
  void add(LessonPlayer& player, const std::string& name, const LessonMeasure& measure) {
    LessonCondition condition;
    condition.measure = measure;
    values_.add(name, std::vector<double>{player.check(condition).value});
  }

  Lesson lesson_;
  test::KeptValues values_;
};

TEST_F(PlayedLesson, MeasuresItsSteps) {
  LessonPlayer player(160, 10, {}, true);
  player.open(lesson_);
  values_.part("work");
  for (std::size_t step = 0; step < 5; ++step) {
    for (const char* name : {"facesCaptured", "skyFacesCaptured", "levelsFiltered"}) {
      add(player, std::to_string(step) + " " + name, measureOf(MeasureKind::Counter, step, name));
    }
  }
  values_.part("claims");
  LessonMeasure difference = measureOf(MeasureKind::Difference, 1);
  add(player, "difference of 1 and 0", difference);
  difference.against = 2;
  add(player, "difference of 1 and 2", difference);
  difference.against = 1;
  add(player, "difference of 1 and 1", difference);
  add(player, "broken", measureOf(MeasureKind::Broken, 2));
  add(player, "turned", measureOf(MeasureKind::Turned, 2));
  for (std::size_t step = 0; step < 5; ++step) {
    add(player, "mean " + std::to_string(step), measureOf(MeasureKind::Mean, step));
  }
  LessonMeasure error = measureOf(MeasureKind::Error, 1);
  error.region = {0.45, 0.6, 0.55, 0.7};
  add(player, "error of 1", error);
  add(player, "error of 1 again", error);
  error.step = 2;
  add(player, "error of 2", error);
  add(player, "view", measureOf(MeasureKind::View, 3, "direction-error"));
  LessonCondition condition;
  condition.measure = measureOf(MeasureKind::Mean, 1);
  condition.times = measureOf(MeasureKind::Mean, 0);
  condition.limit = 0.5;
  condition.comparison = Comparison::Above;
  const ClaimResult result = player.check(condition);
  ASSERT_TRUE(result.divisor);
  EXPECT_NEAR(result.limit, 0.5 * *result.divisor, 1e-9);
  EXPECT_EQ(result.holds, result.value > result.limit);
  for (const LessonMeasure& wrong :
       {measureOf(MeasureKind::Counter, 1, "facesDrawn"), measureOf(MeasureKind::Turned, 1),
        measureOf(MeasureKind::View, 1, "moon"), measureOf(MeasureKind::Field, 1, "probes.hall.exposure")}) {
    condition.measure = wrong;
    EXPECT_THROW(player.check(condition), WorkError) << wrong.name;
  }
  values_.part("pictures");
  for (const std::size_t step : {1u, 2u, 3u, 4u}) {
    player.show(step);
    const ImageRgba8 picture = player.picture();
    ASSERT_EQ(picture.width, 160);
    ASSERT_EQ(picture.height, 10);
    std::vector<double> means;
    for (int column = 0; column < 10; ++column) {
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int i = 0; i < 16 * 10; ++i) {
          sum += picture.pixels[4 * static_cast<std::size_t>(i / 16 * 160 + 16 * column + i % 16) + c];
        }
        means.push_back(std::round(sum / (16 * 10) * 100.0) / 100.0);
      }
    }
    values_.add(std::to_string(step), means);
    EXPECT_NEAR(player.camera().position.x, step >= 3 ? -1.3 : 0.3, 1e-9);
  }
  values_.expect("image/values/lesson_player.txt", 6e-3);
}

TEST_F(PlayedLesson, TriesTasksAndCurves) {
  LessonStep& step = lesson_.steps[1];
  LessonTask task;
  task.done.measure = measureOf(MeasureKind::View, {}, "direction-error");
  task.done.times = measureOf(MeasureKind::View, {}, "hit-error");
  task.done.comparison = Comparison::Within;
  task.done.limit = 0.125;
  task.done.tolerance = 0.25;
  task.unit = "\u00b0";
  task.praise = "well done";
  step.task = task;
  LessonCurve curve;
  curve.field = "probes.room.box.max[0]";
  curve.values = {2.4, 3.0, 3.5};
  curve.measure = measureOf(MeasureKind::View, {}, "direction-error");
  curve.cost = measureOf(MeasureKind::Explain, {}, "/lookupCount");
  curve.line = measureOf(MeasureKind::View, 3, "hit-error");
  lesson_.steps[2].published.clear();
  lesson_.steps[2].curve = curve;
  LessonPlayer player(160, 10, {}, true);
  player.open(lesson_);
  values_.part("task");
  double value = 0.0;
  for (const char* low : {"-2.2", "-1.6", "-2.7"}) {
    player.showChanged(1, {std::string("probes.room.box.min=[") + low + ", 0, -2]"});
    const bool done = player.done(task, 1, &value);
    values_.add(low, std::vector<double>{value, done ? 1.0 : 0.0});
  }
  const auto json = nlohmann::json::parse(player.taskForPage(1));
  EXPECT_EQ(json["done"], "within");
  EXPECT_EQ(json["limit"], 0.125);
  EXPECT_EQ(json["tolerance"], 0.25);
  EXPECT_EQ(json["unit"], "\u00b0");
  EXPECT_EQ(json["praise"], "well done");
  EXPECT_EQ(json["measure"]["kind"], "direction-error");
  EXPECT_EQ(json["times"]["kind"], "hit-error");
  EXPECT_EQ(json["measure"]["rays"], json["times"]["rays"]);
  values_.add("start", std::vector<double>{json["start"].get<double>()});
  const auto& rays = json["measure"]["rays"];
  values_.add("rays", std::vector<std::size_t>{rays.size()});
  for (std::size_t i = 0; i < rays.size(); i += 37) values_.add("ray", rays[i].get<std::vector<double>>());
  task.done.times.reset();
  for (const char* name :
       {"/probes/0/slabFactors/2", "/probes/0/slabFactors/0", "/probes/0/hitDistance", "/surface/nDotV"}) {
    task.done.measure = measureOf(MeasureKind::Explain, {}, name);
    lesson_.steps[1].task = task;
    const std::string page = player.taskForPage(1);
    values_.add(std::string(name) + ": " +
                (page.empty() ? "none" : nlohmann::json::parse(page)["measure"]["axis"].dump()));
  }
  task.done.measure = measureOf(MeasureKind::Explain, {}, "/probes/1/slabFactors/2");
  lesson_.steps[1].task = task;
  EXPECT_THROW(player.taskForPage(1), WorkError) << "there is one probe";
  task.done.measure = measureOf(MeasureKind::View, {}, "level");
  lesson_.steps[1].task = task;
  EXPECT_EQ(player.taskForPage(1), "");
  EXPECT_EQ(player.taskForPage(0), "");
  values_.part("curve");
  const CurvePoints points = player.curve(2);
  values_.add("measured", points.measured);
  values_.add("costs", points.costs);
  values_.add("line", std::vector<double>{points.line.value_or(-1.0)});
  values_.expect("image/values/lesson_tasks.txt", 4e-3);
}

TEST_F(PlayedLesson, ForgetsTheLessonBeforeAndCanBeStopped) {
  bool on = true;
  LessonPlayer player(
      160, 20, [&] { return on; }, true);
  LessonCondition condition;
  condition.measure = measureOf(MeasureKind::Counter, 0, "facesCaptured");
  player.open(lesson_);
  const double faces = player.check(condition).value;
  EXPECT_GE(faces, 6.0);
  const Lesson again = lesson_;
  player.open(again);
  EXPECT_EQ(player.check(condition).value, faces) << "captured afresh";
  player.open(lesson_);
  on = false;
  EXPECT_THROW(player.check(condition), WorkError);
}

}  // namespace
}  // namespace boxprobe::test
