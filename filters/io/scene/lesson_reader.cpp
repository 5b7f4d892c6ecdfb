// The grammar of the lesson file: one function per object, each with the keys it accepts.
#include <filesystem>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/scene/surface_view.h"
#include "filters/io/json/json_cursor.h"
#include "filters/io/scene/lesson_json.h"
#include "filters/io/scene/lesson_language.h"
#include "filters/io/scene/lesson_places.h"

namespace boxprobe {

namespace {

std::string required(const JsonCursor& entry, const char* key) {
  const auto value = entry.find(key);
  if (!value) entry.fail(std::string("has no ") + key + "; add \"" + key + "\": \"...\"");
  std::string text = value->text();
  if (text.empty()) value->fail("is empty");
  return text;
}

std::string optional(const JsonCursor& entry, const char* key) {
  const auto value = entry.find(key);
  return value ? value->text() : std::string();
}

/// An id is required where the texts are separate, and allowed elsewhere.
void checkId(const JsonCursor& entry) {
  if (const auto id = entry.find("id")) lessonTextId(*id);
}

JsonCursor requiredValue(const JsonCursor& entry, const char* key) {
  const auto value = entry.find(key);
  if (!value) entry.fail(std::string("has no ") + key);
  return *value;
}

double share(const JsonCursor& value) {
  const double number = value.number();
  if (!(number >= 0.0 && number <= 1.0)) value.fail("is a share of the picture, from 0 to 1");
  return number;
}

template <std::size_t N>
std::array<double, N> shares(const JsonCursor& value, const char* wanted) {
  value.requireArray();
  const auto elements = value.elements();
  if (elements.size() != N) value.fail(std::string("must be ") + wanted);
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = share(elements[i]);
  return result;
}

PictureRegion readRegion(const JsonCursor& value) {
  const auto region = shares<4>(value, "[left, top, right, bottom], shares of the picture");
  if (!(region[0] < region[2] && region[1] < region[3])) value.fail("is empty; give left, top, right, bottom");
  return region;
}

std::vector<PicturePoint> readPoints(const JsonCursor& value) {
  value.requireArray();
  std::vector<PicturePoint> points;
  for (const JsonCursor& point : value.elements()) points.push_back(shares<2>(point, "[x, y], shares of the picture"));
  return points;
}

/// Command-line assignments from an object of key paths; file names of pictures are relative to the lesson's folder.
std::vector<std::string> readAssignments(const JsonCursor& set, const std::string& folder) {
  set.requireObject();
  std::vector<std::string> assignments;
  for (const JsonCursor& value : set.members()) {
    const std::string& key = value.key();
    const bool file = key.size() > 6 && key.compare(key.size() - 6, 6, ".image") == 0;
    Json json = value.json();
    if (file) json = (std::filesystem::path(folder) / value.text()).lexically_normal().string();
    assignments.push_back(key + "=" + json.dump());
  }
  return assignments;
}

/// Steps are numbered from 1 in the file.
std::size_t readStep(const JsonCursor& value, std::size_t steps) {
  const int step = value.whole();
  if (step < 1 || static_cast<std::size_t>(step) > steps) {
    value.fail("names a step; they are counted from 1 to " + std::to_string(steps));
  }
  return static_cast<std::size_t>(step - 1);
}

LessonMeasure readMeasure(const JsonCursor& entry, std::size_t steps) {
  entry.requireObject({"kind", "step", "against", "region", "channel", "points", "name"});
  LessonMeasure measure;
  measure.kind = static_cast<MeasureKind>(requiredValue(entry, "kind")
                                              .choice({"error", "difference", "mean", "explain", "view", "bend",
                                                       "counter", "field", "jump", "broken", "turned", "fit"}));
  if (const auto step = entry.find("step")) measure.step = readStep(*step, steps);
  if (const auto against = entry.find("against")) {
    if (measure.kind == MeasureKind::Error) {
      measure.box = against->choice({"scene", "box"}) == 1;
    } else if (measure.kind == MeasureKind::Difference) {
      measure.against = readStep(*against, steps);
    } else {
      against->fail("belongs to an error or a difference");
    }
  } else if (measure.kind == MeasureKind::Difference) {
    entry.fail("has no other step; add \"against\": 1");
  }
  if (const auto region = entry.find("region")) {
    measure.region = readRegion(*region);
  }
  if (const auto channel = entry.find("channel")) {
    measure.channel = static_cast<int>(channel->choice({"red", "green", "blue"}));
  }
  if (const auto points = entry.find("points")) measure.points = readPoints(*points);
  const std::size_t wanted = measure.kind == MeasureKind::Explain ? 1 : measure.kind == MeasureKind::Bend ? 3 : 0;
  const bool overRegion = measure.kind == MeasureKind::Explain && measure.points.empty() && entry.find("region");
  if (measure.points.size() != wanted && !overRegion) entry.fail("needs " + std::to_string(wanted) + " points");
  const bool named = measure.kind == MeasureKind::Explain || measure.kind == MeasureKind::View ||
                     measure.kind == MeasureKind::Counter || measure.kind == MeasureKind::Field ||
                     measure.kind == MeasureKind::Fit;
  if (named) measure.name = required(entry, "name");
  if (!named && entry.find("name")) entry.find("name")->fail("does not belong to a measure of this kind");
  if (measure.kind == MeasureKind::View && !findSurfaceView(measure.name)) {
    entry.find("name")->fail("is no view");
  }
  return measure;
}

LessonCondition readCondition(const JsonCursor& entry, std::size_t steps) {
  LessonCondition condition;
  condition.measure = readMeasure(requiredValue(entry, "measure"), steps);
  const auto above = entry.find("above"), below = entry.find("below"), equals = entry.find("equals");
  if ((above ? 1 : 0) + (below ? 1 : 0) + (equals ? 1 : 0) != 1) entry.fail("needs one of above, below and equals");
  const auto times = entry.find("times");
  if (times) condition.times = readMeasure(*times, steps);
  if (equals) {
    condition.comparison = Comparison::Within;
    condition.limit = equals->number();
    condition.tolerance = requiredValue(entry, "within").number();
  } else {
    condition.comparison = above ? Comparison::Above : Comparison::Below;
    condition.limit = (above ? above : below)->number();
  }
  return condition;
}

LessonClaim readClaim(const JsonCursor& entry, std::size_t steps) {
  entry.requireObject({"id", "say", "unit", "measure", "above", "below", "equals", "within", "times"});
  checkId(entry);
  LessonClaim claim;
  claim.say = required(entry, "say");
  claim.unit = optional(entry, "unit");
  claim.condition = readCondition(entry, steps);
  return claim;
}

LessonQuestion readQuestion(const JsonCursor& entry) {
  entry.requireObject({"ask", "answers"});
  LessonQuestion question;
  question.ask = required(entry, "ask");
  const JsonCursor answers = requiredValue(entry, "answers");
  answers.requireArray();
  int right = 0;
  for (const JsonCursor& answer : answers.elements()) {
    answer.requireObject({"id", "text", "right", "reply"});
    checkId(answer);
    const auto isRight = answer.find("right");
    question.answers.push_back({required(answer, "text"), isRight && isRight->boolean(), required(answer, "reply")});
    right += question.answers.back().right ? 1 : 0;
  }
  if (right != 1 || question.answers.size() < 2) answers.fail("needs two or more, one of them \"right\": true");
  return question;
}

LessonTask readTask(const JsonCursor& entry, std::size_t steps, const std::string& folder) {
  entry.requireObject(
      {"ask", "unit", "measure", "above", "below", "equals", "within", "times", "praise", "solution", "mistake"});
  LessonTask task;
  task.ask = required(entry, "ask");
  task.unit = optional(entry, "unit");
  task.praise = required(entry, "praise");
  task.done = readCondition(entry, steps);
  if (task.done.measure.kind == MeasureKind::Fit) {
    entry.fail("measures a fit, which takes too long while somebody drags; make it a claim");
  }
  task.solution = readAssignments(requiredValue(entry, "solution"), folder);
  task.mistake = readAssignments(requiredValue(entry, "mistake"), folder);
  return task;
}

LessonExercise readExercise(const JsonCursor& entry, std::size_t steps) {
  entry.requireObject(
      {"id", "ask", "solution", "formula", "unit", "measure", "above", "below", "equals", "within", "times"});
  checkId(entry);
  LessonExercise exercise;
  exercise.ask = required(entry, "ask");
  exercise.solution = required(entry, "solution");
  exercise.formula = optional(entry, "formula");
  exercise.unit = optional(entry, "unit");
  if (!entry.find("measure")) {
    for (const char* key : {"unit", "above", "below", "equals", "within", "times"}) {
      if (const auto value = entry.find(key)) value->fail("belongs to a measure; add \"measure\": {...}");
    }
    return exercise;
  }
  exercise.condition = readCondition(entry, steps);
  if (!exercise.condition->measure.step) entry.fail("needs the step its measure is of: \"step\": 1");
  return exercise;
}

LessonCurve readCurve(const JsonCursor& entry, std::size_t steps) {
  entry.requireObject(
      {"field", "values", "measure", "cost", "line", "fieldName", "measureName", "costName", "lineName"});
  LessonCurve curve;
  curve.field = required(entry, "field");
  const JsonCursor values = requiredValue(entry, "values");
  values.requireArray();
  for (const JsonCursor& value : values.elements()) {
    const double number = value.number();
    if (!curve.values.empty() && !(number > curve.values.back())) value.fail("must be larger than the one before");
    curve.values.push_back(number);
  }
  if (curve.values.size() < 2 || curve.values.size() > limits::kCurveValues) {
    values.fail("needs 2 to " + std::to_string(limits::kCurveValues) + " numbers");
  }
  curve.fieldName = required(entry, "fieldName");
  const auto measured = [&](const char* key, std::string& name) {
    const JsonCursor value = requiredValue(entry, key);
    name = required(entry, (std::string(key) + "Name").c_str());
    return readMeasure(value, steps);
  };
  curve.measure = measured("measure", curve.measureName);
  if (entry.find("cost")) curve.cost = measured("cost", curve.costName);
  if (entry.find("line")) {
    curve.line = measured("line", curve.lineName);
    if (!curve.line->step) entry.find("line")->fail("needs the step it is of: \"step\": 1");
  }
  return curve;
}

constexpr int kMostLevels = 11;  // for faces of 1024 texels, a probe's maximum
constexpr std::size_t kMostColumns = 7;

LessonMap readMap(const JsonCursor& entry) {
  entry.requireObject({"levels", "face", "lookups"});
  LessonMap map;
  const auto levels = entry.find("levels"), lookups = entry.find("lookups");
  if (levels.has_value() == lookups.has_value()) entry.fail("needs one of levels and lookups");
  if (lookups) {
    if (const auto face = entry.find("face")) face->fail("belongs to levels");
    map.lookups = readRegion(*lookups);
    return map;
  }
  levels->requireArray();
  for (const JsonCursor& value : levels->elements()) {
    const int level = value.whole();
    if (level < 0 || level > kMostLevels) value.fail("is a mip level, from 0 to " + std::to_string(kMostLevels));
    map.levels.push_back(level);
  }
  if (map.levels.empty() || map.levels.size() > kMostColumns) {
    levels->fail("needs 1 to " + std::to_string(kMostColumns) + " levels");
  }
  if (const auto face = entry.find("face")) {
    map.face = static_cast<int>(face->choice({"+x", "-x", "+y", "-y", "+z", "-z"}));
  }
  return map;
}

LessonInset readInset(const JsonCursor& entry) {
  entry.requireObject({"plan", "elevation", "corner"});
  const auto plan = entry.find("plan"), elevation = entry.find("elevation");
  if (plan.has_value() == elevation.has_value()) entry.fail("needs one of plan and elevation");
  LessonInset inset;
  inset.elevation = elevation.has_value();
  inset.at = shares<2>(plan ? *plan : *elevation, "[x, y], shares of the picture");
  if (const auto corner = entry.find("corner")) {
    const std::size_t choice = corner->choice({"top-left", "top-right", "bottom-left", "bottom-right"});
    inset.right = choice % 2 == 1;
    inset.bottom = choice >= 2;
  }
  return inset;
}

/// With the grammar of the scene file.
Camera readStepCamera(const JsonCursor& value, const std::string& folder) {
  value.requireObject();
  Json scene = {{"format", "boxprobe-scene"}, {"version", 1}};
  scene["cameras"]["lesson"] = value.json();
  try {
    return sceneFromJson(scene, folder).cameras.front();
  } catch (const FieldError& error) {
    value.fail(error.reason());
  }
}

std::string scenePath(const std::string& folder, const std::string& relative) {
  return (std::filesystem::path(folder) / relative).lexically_normal().string();
}

LessonStep readStepObject(const JsonCursor& entry, std::size_t steps, const std::string& folder) {
  entry.requireObject({"id", "title", "say", "formula", "formerly", "scene", "set", "camera", "view", "published",
                       "reflections", "boxes", "rays", "mayMove", "question", "task", "curve", "map", "inset"});
  checkId(entry);
  LessonStep step;
  step.title = required(entry, "title");
  step.say = required(entry, "say");
  step.formula = optional(entry, "formula");
  step.mayMove = optional(entry, "mayMove");
  step.view = optional(entry, "view");
  if (!step.view.empty() && !findSurfaceView(step.view)) {
    std::vector<std::string> ids;
    for (const SurfaceViewRow& row : surfaceViews()) ids.emplace_back(row.id);
    const std::string guess = didYouMean(step.view, ids);
    entry.find("view")->fail("is no view" + (guess.empty() ? "; there are " + nameList(ids, ids.size()) : guess));
  }
  step.formerly = optional(entry, "formerly");
  if (entry.find("scene")) step.scene = scenePath(folder, required(entry, "scene"));
  if (const auto set = entry.find("set")) step.assignments = readAssignments(*set, folder);
  if (const auto camera = entry.find("camera")) {
    if (camera->json().is_string())
      step.cameraName = camera->text();
    else
      step.camera = readStepCamera(*camera, folder);
  }
  if (const auto published = entry.find("published")) {
    step.published = publishedForms()[published->choice(publishedForms())];
  }
  if (const auto reflections = entry.find("reflections")) step.reflections = reflections->boolean();
  if (const auto boxes = entry.find("boxes")) step.boxes = boxes->boolean();
  if (const auto rays = entry.find("rays")) step.rays = readPoints(*rays);
  if (const auto question = entry.find("question")) step.question = readQuestion(*question);
  if (const auto task = entry.find("task")) step.task = readTask(*task, steps, folder);
  if (const auto curve = entry.find("curve")) step.curve = readCurve(*curve, steps);
  if (const auto map = entry.find("map")) step.map = readMap(*map);
  if (step.curve && step.map) entry.find("map")->fail("stands beside a curve; a step has one picture");
  if (const auto inset = entry.find("inset")) {
    if (step.drawn()) inset->fail("stands in no view of the scene; the step's picture is a curve or a map");
    if (!step.published.empty()) inset->fail("would draw the program's ray beside a published form's picture");
    step.inset = readInset(*inset);
  }
  return step;
}

}  // namespace

void requireLessonHeader(const Json& json) {
  const JsonCursor root(json, {});
  root.requireObject();
  const auto format = root.find("format");
  if (!format || format->json() != "boxprobe-lesson") {
    root.fail("is not a lesson; it starts with { \"format\": \"boxprobe-lesson\", \"version\": 1, ...");
  }
  const JsonCursor version = requiredValue(root, "version");
  if (version.whole() != 1) version.fail("is not 1, the one this program reads; get a newer program");
  root.requireObject({"format", "version", "language", "unreviewed", "title", "chapter", "summary", "scene", "set",
                      "steps", "claims", "exercises"});
}

Lesson lessonFromJson(const Json& json, const std::string& folder) {
  const JsonCursor root(json, {});
  Lesson lesson;
  if (const auto language = root.find("language")) {
    lesson.language = language->text();
    if (!isLanguageId(lesson.language)) language->fail("must be a language, such as \"en\" or \"pt-BR\"");
  }
  lesson.unreviewed = optional(root, "unreviewed");
  lesson.title = required(root, "title");
  lesson.chapter = required(root, "chapter");
  lesson.summary = required(root, "summary");
  lesson.scene = scenePath(folder, required(root, "scene"));
  if (const auto set = root.find("set")) lesson.assignments = readAssignments(*set, folder);
  const JsonCursor steps = requiredValue(root, "steps");
  steps.requireArray();
  const auto entries = steps.elements();
  if (entries.empty()) steps.fail("is empty; a lesson has one step or more");
  for (const JsonCursor& step : entries) lesson.steps.push_back(readStepObject(step, entries.size(), folder));
  if (const auto claims = root.find("claims")) {
    claims->requireArray();
    for (const JsonCursor& claim : claims->elements()) {
      lesson.claims.push_back(readClaim(claim, entries.size()));
      if (!lesson.claims.back().condition.measure.step) claim.fail("needs the step its measure is of: \"step\": 1");
    }
  }
  if (const auto exercises = root.find("exercises")) {
    exercises->requireArray();
    for (const JsonCursor& exercise : exercises->elements()) {
      lesson.exercises.push_back(readExercise(exercise, entries.size()));
    }
  }
  return lesson;
}

}  // namespace boxprobe
