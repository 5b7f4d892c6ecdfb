// A lesson that uses every key of its grammar, read whole, and every refusal of its reader, against lesson_reader.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filters/core/scene/lesson.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/io/scene/lesson_json.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

void addMeasure(test::KeptValues& values, const std::string& label, const LessonMeasure& m) {
  values.add(label + " measure " + std::to_string(static_cast<int>(m.kind)) + " step " +
             (m.step ? std::to_string(*m.step) : "own") + " against " + std::to_string(m.against) +
             (m.box ? " box" : "") + " channel " + std::to_string(m.channel) + " '" + m.name + "'");
  values.add(label + "   region", {m.region.begin(), m.region.end()});
  for (const PicturePoint& point : m.points) values.add(label + "   point", {point[0], point[1]});
}

void addCondition(test::KeptValues& values, const std::string& label, const LessonCondition& c) {
  addMeasure(values, label, c.measure);
  values.add(label + " compared " + std::to_string(static_cast<int>(c.comparison)), {c.limit, c.tolerance});
  if (c.times) addMeasure(values, label + " times", *c.times);
}

std::string bracketed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += " [" + text + "]";
  return all;
}

void addStep(test::KeptValues& values, const LessonStep& s) {
  values.add("step '" + s.title + "' '" + s.say + "' '" + s.formula + "' '" + s.formerly + "' '" + s.scene + "' '" +
             s.cameraName + "' '" + s.view + "' '" + s.published + "' '" + s.mayMove + "'" +
             (s.reflections ? " reflections" : "") + (s.boxes ? " boxes" : "") + (s.drawn() ? " drawn" : ""));
  values.add("  set" + bracketed(s.assignments));
  if (s.camera) {
    values.add("  camera " + s.camera->name,
               {s.camera->position.x, s.camera->position.y, s.camera->position.z, s.camera->verticalFovDegrees});
  }
  for (const PicturePoint& ray : s.rays) values.add("  ray", {ray[0], ray[1]});
  if (s.question) {
    values.add("  question '" + s.question->ask + "'");
    for (const LessonAnswer& a : s.question->answers) {
      values.add("    '" + a.text + "' '" + a.reply + "'" + (a.right ? " right" : ""));
    }
  }
  if (s.task) {
    values.add("  task '" + s.task->ask + "' '" + s.task->unit + "' '" + s.task->praise + "'" +
               bracketed(s.task->solution) + " not" + bracketed(s.task->mistake));
    addCondition(values, "  task", s.task->done);
  }
  if (s.curve) {
    const LessonCurve& c = *s.curve;
    values.add("  curve '" + c.field + "' '" + c.fieldName + "' '" + c.measureName + "' '" + c.costName + "' '" +
               c.lineName + "'");
    values.add("  values", c.values);
    addMeasure(values, "  curve", c.measure);
    if (c.cost) addMeasure(values, "  cost", *c.cost);
    if (c.line) addMeasure(values, "  line", *c.line);
  }
  if (s.map) {
    values.add("  map face " + std::to_string(s.map->face), {s.map->levels.begin(), s.map->levels.end()});
    if (s.map->lookups) values.add("  lookups", {s.map->lookups->begin(), s.map->lookups->end()});
  }
  if (s.inset) {
    values.add(std::string("  inset") + (s.inset->elevation ? " elevation" : "") + (s.inset->right ? " right" : "") +
                   (s.inset->bottom ? " bottom" : ""),
               {s.inset->at[0], s.inset->at[1]});
  }
}

void addLesson(test::KeptValues& values, const Lesson& lesson) {
  values.add("lesson '" + lesson.language + "' '" + lesson.unreviewed + "' '" + lesson.title + "' '" + lesson.chapter +
             "' '" + lesson.summary + "' '" + lesson.scene + "'" + bracketed(lesson.assignments));
  for (const LessonStep& step : lesson.steps) addStep(values, step);
  for (const LessonClaim& claim : lesson.claims) {
    values.add("claim '" + claim.say + "' '" + claim.unit + "'");
    addCondition(values, "  claim", claim.condition);
  }
  for (const LessonExercise& e : lesson.exercises) {
    values.add("exercise '" + e.ask + "' '" + e.solution + "' '" + e.formula + "' '" + e.unit + "'");
    if (e.condition) addCondition(values, "  exercise", *e.condition);
  }
}

const char* const kLesson = R"({"format": "boxprobe-lesson", "version": 1, "language": "pt-BR", "unreviewed": "note",
"title": "T", "chapter": "C", "summary": "S", "scene": "../scenes/a.json",
"set": {"exposure": 2, "probes.room.image": "p/a.exr", "sky.image": "/abs/b.hdr", "x.imagery": "c"},
"steps": [
{"id": "one", "title": "t1", "say": "s1", "formula": "F", "formerly": "old", "scene": "b/../c.json",
 "set": {"probes.room.bounces": 3}, "camera": "main", "view": "level", "published": "masking", "reflections": false,
 "boxes": true, "rays": [[0, 1], [0.25, 0.5]], "mayMove": "it",
 "question": {"ask": "q", "answers": [{"id": "a", "text": "ta", "reply": "ra"}, {"text": "tb", "right": true, "reply": "rb"},
   {"text": "tc", "right": false, "reply": "rc"}]}},
{"title": "t2", "say": "s2", "camera": {"position": [1, 2, 3], "verticalFovDegrees": 33},
 "task": {"ask": "do", "unit": "m", "praise": "well", "solution": {"exposure": 3}, "mistake": {"exposure": 1.5, "a.b": "c"},
  "measure": {"kind": "bend", "points": [[0, 0.25], [0.5, 0.75], [1, 0.125]]}, "above": 2.5,
  "times": {"kind": "mean", "step": 3, "channel": "blue", "region": [0.1, 0.2, 0.7, 0.9]}},
 "inset": {"elevation": [0.25, 0.75], "corner": "top-right"}},
{"title": "t3", "say": "s3", "curve": {"field": "exposure", "values": [0.5, 1, 2], "fieldName": "fn",
  "measure": {"kind": "difference", "step": 1, "against": 2}, "measureName": "mn",
  "cost": {"kind": "counter", "name": "lookups"}, "costName": "cn",
  "line": {"kind": "error", "step": 2, "against": "box"}, "lineName": "ln"}},
{"title": "t4", "say": "s4", "map": {"levels": [0, 11, 3], "face": "-z"}},
{"title": "t5", "say": "s5", "map": {"lookups": [0.1, 0.2, 0.3, 0.4]}},
{"title": "t6", "say": "s6", "inset": {"plan": [0, 1], "corner": "top-left"}},
{"title": "t7", "say": "s7", "inset": {"plan": [1, 0], "corner": "bottom-left"}}],
"claims": [
{"id": "c1", "say": "c", "unit": "u", "measure": {"kind": "mean", "step": 1, "channel": "red"}, "above": 1},
{"say": "c", "measure": {"kind": "explain", "step": 2, "name": "/a", "points": [[0.5, 0.5]]}, "below": 2},
{"say": "c", "measure": {"kind": "explain", "step": 2, "name": "/a", "region": [0, 0, 1, 0.5]}, "below": 2},
{"say": "c", "measure": {"kind": "view", "step": 7, "name": "hit-error"}, "equals": 3, "within": 0.25},
{"say": "c", "measure": {"kind": "field", "step": 1, "name": "exposure"}, "below": 4},
{"say": "c", "measure": {"kind": "jump", "step": 1}, "below": 4},
{"say": "c", "measure": {"kind": "broken", "step": 1}, "below": 4},
{"say": "c", "measure": {"kind": "turned", "step": 1}, "below": 4},
{"say": "c", "measure": {"kind": "fit", "step": 1, "name": "/x"}, "below": 4},
{"say": "c", "measure": {"kind": "error", "step": 1, "against": "scene"}, "below": 4}],
"exercises": [{"id": "e", "ask": "a", "solution": "s", "formula": "f", "unit": "m",
  "measure": {"kind": "mean", "step": 1, "channel": "green"}, "equals": 1, "within": 2}, {"ask": "b", "solution": "t"}]})";

/// A lesson of two steps; `step` and `lesson` are further members.
std::string small(const std::string& step, const std::string& lesson = "") {
  return R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a", "steps": [{"title": "t", "say": "s")" +
         (step.empty() ? "" : ", " + step) + R"(}, {"title": "u", "say": "s"}])" +
         (lesson.empty() ? "" : ", " + lesson) + "}";
}

TEST(LessonValues, EverythingInALesson) {
  test::KeptValues values;
  const Json json = Json::parse(kLesson);
  requireLessonHeader(json);
  addLesson(values, lessonFromJson(json, "/lessons"));
  addLesson(values, lessonFromJson(Json::parse(small("")), ""));
  const auto refused = [&](const std::string& text) {
    try {
      lessonFromJson(Json::parse(text), "");
      ADD_FAILURE() << "is read: " << text;
    } catch (const FieldError& error) {
      values.add(error.what());
    }
  };
  const auto step = [&](const std::string& member) { refused(small(member)); };
  const auto measure = [&](const std::string& members) {
    refused(small("", R"("claims": [{"say": "c", "above": 1, "measure": {)" + members + "}}]"));
  };
  for (const char* key : {"title", "chapter", "summary", "scene"}) {
    Json without = Json::parse(small(""));
    without.erase(key);
    refused(without.dump());
    without[key] = "";
    refused(without.dump());
    without[key] = 3;
    refused(without.dump());
  }
  refused(R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a"})");
  refused(R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a", "steps": []})");
  refused(R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a", "steps": {}})");
  refused(R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a", "steps": [{"say": "s"}]})");
  refused(R"({"title": "T", "chapter": "C", "summary": "S", "scene": "a", "steps": [{"title": "s"}]})");
  for (const char* member : {R"("language": "")", R"("language": "e n")", R"("unreviewed": 3)", R"("set": [])",
                             R"("claims": {})", R"("exercises": 3)"}) {
    refused(small("", member));
  }
  for (
      const char* member :
      {R"("id": "A")",
       R"("id": "")",
       R"("formula": 3)",
       R"("mayMove": true)",
       R"("view": "levle")",
       R"("view": "zzzzzzzz")",
       R"("formerly": 1)",
       R"("scene": "")",
       R"("set": 3)",
       R"("set": {"a.image": 3})",
       R"("camera": 3)",
       R"("camera": {"fov": 3})",
       R"("published": "x")",
       R"("reflections": 1)",
       R"("boxes": "yes")",
       R"("rays": {})",
       R"("rays": [[0.5]])",
       R"("rays": [[0, -0.1]])",
       R"("rays": [[1.1, 0]])",
       R"("rays": [[0, 0, 0]])",
       R"("rays": [["a", 0]])",
       R"("question": 3)",
       R"("question": {"answers": []})",
       R"("question": {"ask": "q"})",
       R"("question": {"ask": "q", "answers": {}})",
       R"("question": {"ask": "q", "answers": [{"text": "a", "reply": "b", "right": true}]})",
       R"("question": {"ask": "q", "answers": [{"text": "a", "reply": "b", "right": true}, {"text": "a", "reply": "b", "right": true}]})",
       R"("question": {"ask": "q", "answers": [{"text": "a"}, {"text": "a", "reply": "b", "right": true}]})",
       R"("question": {"ask": "q", "answers": [{"reply": "a"}, {"text": "a", "reply": "b", "right": true}]})",
       R"("question": {"ask": "q", "answers": [{"id": "*", "text": "a", "reply": "b"}]})",
       R"("task": {})",
       R"("task": {"ask": "a"})",
       R"("task": {"ask": "a", "praise": "p"})",
       R"("task": {"ask": "a", "praise": "p", "measure": {"kind": "mean"}, "above": 1})",
       R"("task": {"ask": "a", "praise": "p", "measure": {"kind": "mean"}, "above": 1, "solution": {}})",
       R"("task": {"ask": "a", "praise": "p", "measure": {"kind": "fit", "name": "n"}, "above": 1, "solution": {}, "mistake": {}})",
       R"("map": {"levels": [12]})",
       R"("map": {"levels": [-1]})",
       R"("map": {"levels": [0, 1, 2, 3, 4, 5, 6, 7]})",
       R"("map": {"levels": 3})",
       R"("map": {"levels": [0.5]})",
       R"("map": {"lookups": [0, 0, 1]})",
       R"("map": {"lookups": [0.5, 0, 0.5, 1]})",
       R"("map": {"lookups": [0, 0.5, 1, 0.5]})",
       R"("map": {"lookups": [0, 0, 1, 1], "face": "+x"})",
       R"("map": {"levels": [0], "face": "up"})",
       R"("inset": {"plan": [0, 0], "elevation": [0, 0]})",
       R"("inset": {"corner": "top-left"})",
       R"("inset": {"plan": [0]})",
       R"("inset": {"plan": [0, 0], "corner": "top"})",
       R"("inset": {"plan": [0, 0]}, "map": {"levels": [0]})",
       R"("inset": {"plan": [0, 0]}, "published": "half")"}) {
    step(member);
  }
  const auto curve = [&](const std::string& members) { step("\"curve\": {" + members + "}"); };
  const std::string field = R"("field": "exposure", "fieldName": "n", )", mean = R"("measure": {"kind": "mean"}, )";
  curve("");
  curve(R"("field": "exposure")");
  curve(R"("field": "exposure", "values": 3)");
  curve(field + R"("values": [1])");
  curve(field + R"("values": [1, 1])");
  std::string many = "1";
  for (int i = 2; i <= 33; ++i) many += ", " + std::to_string(i);
  curve(field + "\"values\": [" + many + "]");
  curve(R"("field": "exposure", "values": [1, 2])");
  curve(field + R"("values": [1, 2])");
  curve(field + R"("values": [1, 2], "measure": {"kind": "mean"})");
  curve(field + mean + R"("values": [1, 2], "measureName": "m", "cost": {"kind": "mean"})");
  curve(field + mean + R"("values": [1, 2], "measureName": "m", "line": {"kind": "mean"}, "lineName": "l")");
  step(
      R"("curve": {"field": "exposure", "fieldName": "n", "values": [1, 2], "measure": {"kind": "mean"}, "measureName": "m"}, "map": {"levels": [0]})");
  for (const char* members : {"",
                              R"("kind": "x")",
                              R"("kind": "mean")",
                              R"("kind": "mean", "step": 0)",
                              R"("kind": "mean", "step": 3)",
                              R"("kind": "mean", "step": 1.5)",
                              R"("kind": "mean", "step": 1, "against": 2)",
                              R"("kind": "difference", "step": 1)",
                              R"("kind": "difference", "step": 1, "against": 3)",
                              R"("kind": "error", "step": 1, "against": "room")",
                              R"("kind": "mean", "step": 1, "region": [0, 0, 0, 1])",
                              R"("kind": "mean", "step": 1, "channel": "alpha")",
                              R"("kind": "mean", "step": 1, "points": [[0, 0]])",
                              R"("kind": "explain", "step": 1, "name": "n")",
                              R"("kind": "explain", "step": 1, "points": [[0, 0]])",
                              R"("kind": "bend", "step": 1, "points": [[0, 0]])",
                              R"("kind": "bend", "step": 1, "region": [0, 0, 1, 1])",
                              R"("kind": "mean", "step": 1, "name": "n")",
                              R"("kind": "view", "step": 1)",
                              R"("kind": "view", "step": 1, "name": "n")",
                              R"("kind": "counter", "step": 1)",
                              R"("kind": "field", "step": 1)",
                              R"("kind": "fit", "step": 1)",
                              R"("step": 1)",
                              R"("kind": "mean", "step": 1, "x": 1)"}) {
    measure(members);
  }
  const auto claim = [&](const std::string& members) {
    refused(small("", R"("claims": [{"say": "c", "measure": {"kind": "mean", "step": 1}, )" + members + "}]"));
  };
  claim(R"("unit": "m")");
  claim(R"("above": 1, "below": 2)");
  claim(R"("above": 1, "equals": 2)");
  claim(R"("below": 1, "equals": 2)");
  claim(R"("equals": 2)");
  claim(R"("above": "x")");
  claim(R"("above": 1, "times": 3)");
  claim(R"("above": 1, "id": "Q")");
  for (const char* members :
       {R"("ask": "a")", R"("solution": "s")", R"("ask": "a", "solution": "s", "unit": "m")",
        R"("ask": "a", "solution": "s", "below": 1)", R"("ask": "a", "solution": "s", "equals": 1)",
        R"("ask": "a", "solution": "s", "within": 1)", R"("ask": "a", "solution": "s", "times": {})",
        R"("ask": "a", "solution": "s", "measure": {"kind": "mean"}, "above": 1)"}) {
    refused(small("", std::string("\"exercises\": [{") + members + "}]"));
  }
  for (const char* header : {"[]", "{}", R"({"format": "x"})", R"({"format": "boxprobe-lesson"})",
                             R"({"format": "boxprobe-lesson", "version": 2})",
                             R"({"format": "boxprobe-lesson", "version": 1, "stps": []})"}) {
    try {
      requireLessonHeader(Json::parse(header));
      ADD_FAILURE() << header;
    } catch (const FieldError& error) {
      values.add(error.what());
    }
  }
  values.expect("unit/values/lesson_reader.txt");
}

class LessonFolder : public TemporaryFolder {};

TEST_F(LessonFolder, NamesComeFromFiles) {
  const std::string text = R"({"format": "boxprobe-lesson", "version": 1, "title": "T", "chapter": "C", "summary": "S",
    "scene": ")" BOXPROBE_DATA_DIR R"(/scenes/room.boxprobe.json", "steps": [{"title": "t", "say": "s", "camera": "C"},
    {"title": "t", "say": "s"}, {"title": "t", "say": "s", "camera": {"position": [1, 2, 3]}}, {"title": "t", "say": "s"}]})";
  for (const auto& [file, name] : {std::pair{"12-floor-mirror.lesson.json", "floor-mirror"},
                                   {"plain.lesson.json", "plain"},
                                   {"-x.lesson.json", "-x"},
                                   {"12.lesson.json", "12"},
                                   {"12x-y.lesson.json", "12x-y"}}) {
    EXPECT_EQ(loadLessonFile(write(file, text)).name, name);
  }
  const Lesson lesson = loadLessonFile(file("plain.lesson.json"));
  EXPECT_EQ(lesson.path, file("plain.lesson.json"));
  EXPECT_EQ(lessonCamera(lesson, 0, lessonScene(lesson, 0)).name, "C");
  EXPECT_EQ(lessonCamera(lesson, 1, lessonScene(lesson, 1)).name, "C");
  EXPECT_EQ(lessonCamera(lesson, 2, lessonScene(lesson, 2)).position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(lessonCamera(lesson, 3, lessonScene(lesson, 3)).position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(lessonCamera(Lesson{"", "", "", "", "", "", "", "", {}, {LessonStep{}}, {}, {}}, 0, Scene()), Camera());
  write(".lesson.json", text);
  EXPECT_EQ(loadLessons(folder_.string()).lessons.size(), 5u) << "a file without a name is none";
}

}  // namespace
}  // namespace boxprobe
