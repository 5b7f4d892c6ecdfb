// What a sheet and a page of a lesson are made from, of a lesson with each kind of picture, against
// lesson_photographs.txt: the pictures as mean colours of cells, what was measured, and the pictures of a loop.
#include <gtest/gtest.h>

#include <map>

#include "app/gui/lessons/lesson_loops.h"
#include "app/gui/lessons/lesson_pictures.h"
#include "filters/core/base/errors.h"
#include "tests/gui/kept_pictures.h"

namespace boxprobe {
namespace {

// Of 255: drivers draw light a little otherwise.
constexpr int kSame = 6;

Lesson lesson() {
  Lesson made;
  made.name = "pictured";
  made.path = "pictured.lesson.json";
  made.title = "Pictured";
  made.scene = BOXPROBE_DATA_DIR "/scenes/room.boxprobe.json";
  made.assignments = {"probes.room.faceSize=32", "probes.room.samplesPerPixel=1", "probes.room.technique=\"box\""};
  made.steps.resize(6);
  LessonStep& lettered = made.steps[0];
  lettered.cameraName = "A";
  lettered.boxes = true;
  lettered.rays = {{0.62, 0.78}};
  lettered.mayMove = "A face.";
  lettered.inset = LessonInset{{0.62, 0.78}, false, true, true};
  LessonStep& two = made.steps[1];
  two.rays = {{0.55, 0.75}, {0.31, 0.83}};
  two.inset = LessonInset{{0.41, 0.86}, true, false, false};
  LessonStep& levels = made.steps[2];
  levels.map.emplace();
  levels.map->levels = {0, 2, 3};
  levels.map->face = 4;
  LessonStep& lookups = made.steps[3];
  lookups.map.emplace();
  lookups.map->lookups = PictureRegion{0.04, 0.55, 0.93, 1.0};
  lookups.assignments = {"probes.room.technique=\"infinite\""};
  LessonStep& curve = made.steps[4];
  curve.curve.emplace();
  curve.curve->field = "materials.floor.roughness";
  curve.curve->values = {0.1, 0.5, 0.8};
  curve.curve->measure.kind = MeasureKind::Mean;
  curve.curve->cost = curve.curve->measure;
  curve.curve->cost->channel = 2;
  curve.curve->line = curve.curve->measure;
  curve.curve->line->step = 0;
  curve.curve->fieldName = "roughness";
  curve.curve->measureName = "light";
  curve.curve->costName = "blue";
  curve.curve->lineName = "as first";
  made.steps[5].boxes = true;
  LessonMeasure mean;
  mean.step = 1;
  LessonCondition bright;
  bright.measure = mean;
  bright.comparison = Comparison::Above;
  bright.limit = 0.001;
  LessonCondition dark = bright;
  dark.comparison = Comparison::Below;
  dark.times = mean;
  dark.limit = 0.5;
  made.claims = {{"It is bright.", "", bright}, {"It is half as bright.", "", dark}};
  made.exercises.resize(2);
  made.exercises[1].ask = "How bright?";
  made.exercises[1].condition = bright;
  return made;
}

TEST(LessonPhotographs, AreAsBefore) {
  LessonPhotographer photographer(320, 200);
  const Lesson shown = lesson();
  const LessonPictures pictures = photographer.take(shown, PicturePoint{0.62, 0.78});
  std::map<std::string, std::string> now;
  std::map<std::string, QImage> images;
  for (std::size_t i = 0; i < pictures.steps.size(); ++i) images["step " + std::to_string(i)] = pictures.steps[i];

  LessonLoop loop;
  loop.name = "loop";
  loop.steps = {0, 5};
  loop.labels = {"before", "after"};
  loop.seconds = 5.0 / kLoopRate;
  loop.boxes = true;
  LessonLoop::Field field;
  field.path = "probes.room.box.max";
  field.from = {4.0, 3.0, 3.0};
  field.to = {5.0, 3.0, 3.5};
  loop.fields = {field};
  loop.walk.resize(2);
  loop.walk[0].position = {1.0, 1.6, 2.0};
  loop.walk[0].target = {0.0, 1.0, 0.0};
  loop.walk[1].position = {-1.0, 1.3, 2.2};
  loop.walk[1].target = {0.3, 0.8, 0.0};
  loop.walk[1].verticalFovDegrees = loop.walk[0].verticalFovDegrees + 20.0;
  std::string drawn;
  const std::vector<QImage> film = drawLoop(
      photographer, shown, loop, [&](double share) { drawn += QString::number(share, 'f', 3).toStdString() + " "; });
  for (std::size_t i = 0; i < film.size(); ++i) images["loop " + std::to_string(i)] = film[i];
  now["loop drawn"] = drawn;
  loop.steps = {0, 6};
  try {
    drawLoop(photographer, shown, loop, [](double) {});
  } catch (const InputError& error) {
    now["loop of a step that is not there"] = error.what();
  }
  std::string same;
  for (const bool each : pictures.sameView) same += each ? "same " : "other ";
  now["views"] = same;
  now["plan"] = pictures.plan ? "there" : "none";
  now["task"] = pictures.task;
  std::string holds;
  for (const LessonPictures::Claim& claim : pictures.claims) holds += claim.say + (claim.holds ? " yes; " : " no; ");
  for (const auto& exercise : pictures.exercises)
    holds += exercise ? exercise->say + (exercise->holds ? " yes; " : " no; ") : "none; ";
  now["claims"] = holds;
  expectKeptPictures("gui/values/lesson_photographs.txt", images, now, kSame);
}

}  // namespace
}  // namespace boxprobe
