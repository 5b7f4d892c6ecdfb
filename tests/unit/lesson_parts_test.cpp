// What lessons are made of without a picture: the page's own file, formulas, plans, fits and limits, compared with what
// the page and the formulas are documented to be, and with lesson_plans.txt and lesson_maps.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/lessons/fit_measure.h"
#include "app/lessons/formula_mathml.h"
#include "app/lessons/lesson_measure.h"
#include "app/lessons/other_maps.h"
#include "app/lessons/page_sketches.h"
#include "app/lessons/page_widgets.h"
#include "app/lessons/plan_figure.h"
#include "app/session/load_scene.h"
#include "filters/fit/fit_probe.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"
#include "tests/unit/explained_room.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PageFile : public TemporaryFolder {
 protected:
  PageWidgets page(const std::string& members) const {
    write("page.json",
          R"({"format": "boxprobe-lesson-page", "version": 1)" + (members.empty() ? "" : ", " + members) + "}");
    return loadPageWidgets(file(""));
  }
  /// Which place is refused; "" for a page that is read.
  std::string refused(const std::string& members) const {
    try {
      page(members);
      return "";
    } catch (const InputError& error) {
      const std::string text = error.what(), path = file("page.json") + ": ";
      EXPECT_EQ(text.rfind(path, 0), 0u) << text;
      return text.substr(path.size(), text.find("; expected") - path.size());
    }
  }
  /// A film with one member in another way.
  std::string loop(const std::string& what = "", const std::string& by = "") const {
    std::string text = R"({"name": "walk-2", "lesson": "one", "steps": [2, 1], "labels": ["L", "R"], "say": "S",
      "seconds": 2.5, "boxes": true, "from": {"exposure": 1, "probes.room.origin": [0, 1, 2], "camera": {"position":
      [1, 2, 3], "target": [4, 5, 6], "verticalFovDegrees": 50}}, "to": {"exposure": 3, "probes.room.origin": [2, 1, 0],
      "camera": {"position": [7, 8, 9], "target": [0, 1, 2], "verticalFovDegrees": 60}}})";
    if (!what.empty()) {
      EXPECT_NE(text.find(what), std::string::npos) << what;
      text.replace(text.find(what), what.size(), by);
    }
    return R"("loops": [)" + text + "]";
  }
};

TEST_F(PageFile, IsReadWhole) {
  EXPECT_TRUE(loadPageWidgets(file("")).rooms.empty()) << "there is none";
  const PageWidgets read = page(R"("plans": {"one": [0.25, 0.75], "two": [0, 1]}, "rooms": ["one", "three"],
    "figures": {"infinity": "one", "stand": ["one", "three"], "cone": ["two"], "ball": "four"},
    "code": {"one": {"say": "do", "start": ["a", "b"], "answer": ["c"]}},
    "sources": [{"title": "T", "address": "https://x"}, {"title": "U", "address": "https://y"}], )" +
                                loop());
  EXPECT_EQ(read.plans.at("one"), (PicturePoint{0.25, 0.75}));
  EXPECT_EQ(read.plans.at("two"), (PicturePoint{0.0, 1.0}));
  EXPECT_THAT(read.rooms, ElementsAre("one", "three"));
  EXPECT_EQ(read.figures.size(), 4u);
  EXPECT_THAT(read.figures.at("infinity"), ElementsAre("one"));
  EXPECT_THAT(read.figures.at("stand"), ElementsAre("one", "three"));
  EXPECT_THAT(read.figures.at("ball"), ElementsAre("four"));
  EXPECT_EQ(read.code.at("one").say, "do");
  EXPECT_EQ(read.code.at("one").start, "a\nb");
  EXPECT_EQ(read.code.at("one").answer, "c");
  ASSERT_EQ(read.sources.size(), 2u);
  EXPECT_EQ(read.sources[1].title, "U");
  EXPECT_EQ(read.sources[1].address, "https://y");
  ASSERT_EQ(read.loops.size(), 1u);
  const LessonLoop& film = read.loops[0];
  EXPECT_EQ(film.name, "walk-2");
  EXPECT_EQ(film.lesson, "one");
  EXPECT_EQ(film.say, "S");
  EXPECT_THAT(film.steps, ElementsAre(1u, 0u));
  EXPECT_THAT(film.labels, ElementsAre("L", "R"));
  EXPECT_EQ(film.seconds, 2.5);
  EXPECT_TRUE(film.boxes);
  ASSERT_EQ(film.fields.size(), 2u);
  EXPECT_EQ(film.fields[0].at(0.25), "exposure=1.5");
  EXPECT_EQ(film.fields[1].at(0.25), "probes.room.origin=[0.5, 1, 1.5]");
  EXPECT_EQ(film.fields[1].at(1.0), "probes.room.origin=[2, 1, 0]");
  ASSERT_EQ(film.walk.size(), 2u);
  EXPECT_EQ(film.walk[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(film.walk[0].target, glm::dvec3(4, 5, 6));
  EXPECT_EQ(film.walk[1].position, glm::dvec3(7, 8, 9));
  EXPECT_EQ(film.walk[1].verticalFovDegrees, 60.0);
  const LessonLoop plain = page(loop(R"("seconds": 2.5, "boxes": true, )")).loops[0];
  EXPECT_EQ(plain.seconds, 4.0);
  EXPECT_FALSE(plain.boxes);
  std::vector<Lesson> lessons(2);
  lessons[0].name = "one";
  lessons[1].name = "three";
  EXPECT_THAT(unmatchedWidgets(read, lessons),
              ElementsAre("page.json: two: there is no such lesson; nothing of it is in the page",
                          "page.json: four: there is no such lesson; nothing of it is in the page",
                          "page.json: two: there is no such lesson; nothing of it is in the page"));
  lessons.pop_back();
  EXPECT_EQ(unmatchedWidgets(read, lessons).size(), 5u);
}

TEST_F(PageFile, EachMistakeHasItsPlace) {
  for (const auto& [members, place] : std::vector<std::pair<std::string, std::string>>{
           {R"("plans": {"one": [0, 1.01]})", "plans.one"},
           {R"("plans": {"one": [1.01, 0]})", "plans.one"},
           {R"("plans": {"one": [-0.01, 0]})", "plans.one"},
           {R"("plans": {"one": [0, -0.01]})", "plans.one"},
           {R"("plans": {"one": [0]})", "plans.one"},
           {R"("plans": {"one": [0, 0, 0]})", "plans.one"},
           {R"("plans": {"one": ["0", 0]})", "plans.one"},
           {R"("plans": {"one": [0, "0"]})", "plans.one"},
           {R"("plans": {"one": 1})", "plans.one"},
           {R"("plans": [])", "plans"},
           {R"("rooms": "one")", "rooms"},
           {R"("rooms": [1])", "rooms"},
           {R"("figures": {"cone": []})", "figures.cone"},
           {R"("figures": {"cone": 1})", "figures.cone"},
           {R"("figures": {"cone": ["a", 1]})", "figures.cone"},
           {R"("figures": {"moon": "a"})", "figures.moon"},
           {R"("figures": [])", "figures"},
           {R"("figures": {"stand": ["a", "b"]}, "rooms": ["a"])", "figures.stand"},
           {R"("figures": {"infinity": "a"})", "figures.infinity"},
           {R"("code": {"a": {"say": "s", "start": ["x"], "answer": ["y"]}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": {"say": 1, "start": ["x"], "answer": ["y"]}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": {"say": "s", "start": [], "answer": ["y"]}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": {"say": "s", "start": ["x"], "answer": [1]}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": {"say": "s", "start": ["x"], "answer": "y"}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": {"say": "s", "start": ["x"], "answer": ["y"], "z": 1}})", "code.a"},
           {R"("rooms": ["a"], "code": {"a": "x"})", "code.a"},
           {R"("code": [])", "code"},
           {R"("sources": [{"title": "T", "address": "https://x"}, {"title": "", "address": "https://x"}])",
            "sources[1]"},
           {R"("sources": [{"title": "T", "address": "see https://x"}])", "sources[0]"},
           {R"("sources": [{"address": "https://x"}])", "sources[0]"},
           {R"("sources": ["https://x"])", "sources[0]"},
           {R"("sources": {})", "sources"},
           {R"("loops": {})", "loops"},
           {R"("walls": 1)", "walls"},
           {loop("walk-2", "Walk"), "loops[0].name"},
           {loop("walk-2", ""), "loops[0].name"},
           {loop("\"walk-2\"", "2"), "loops[0].name"},
           {loop("\"lesson\": \"one\"", "\"lesson\": 1"), "loops[0].lesson"},
           {loop("\"say\": \"S\"", "\"say\": 1"), "loops[0].say"},
           {loop("[2, 1]", "[0, 1]"), "loops[0].steps"},
           {loop("[2, 1]", "[-1, 1]"), "loops[0].steps"},
           {loop("[2, 1]", "[1.5, 1]"), "loops[0].steps"},
           {loop("[2, 1]", "[]"), "loops[0].steps"},
           {loop("[2, 1]", "[1, 2, 3]"), "loops[0].steps"},
           {loop("[2, 1]", "2"), "loops[0].steps"},
           {loop("[\"L\", \"R\"]", "[\"L\"]"), "loops[0].labels"},
           {loop("[\"L\", \"R\"]", "[\"L\", 2]"), "loops[0].labels"},
           {loop("[\"L\", \"R\"]", "\"L\""), "loops[0].labels"},
           {loop("2.5", "0.99"), "loops[0].seconds"},
           {loop("2.5", "20.1"), "loops[0].seconds"},
           {loop("2.5", "\"2\""), "loops[0].seconds"},
           {loop("\"boxes\": true", "\"boxes\": 1"), "loops[0].boxes"},
           {loop("\"boxes\": true", "\"box\": true"), "loops[0].box"},
           {loop("\"exposure\": 3, ", ""), "loops[0].to"},
           {loop("\"exposure\": 3", "\"tone\": 3"), "loops[0].to.exposure"},
           {loop("\"exposure\": 3", "\"exposure\": \"3\""), "loops[0].from.exposure"},
           {loop("\"exposure\": 3", "\"exposure\": [3, 4]"), "loops[0].from.exposure"},
           {loop("[0, 1, 2]", "[0, 1]"), "loops[0].from.probes.room.origin"},
           {loop("[0, 1, 2]", "[0, 1, \"2\"]"), "loops[0].from.probes.room.origin"},
           {loop("[0, 1, 2]", "[]"), "loops[0].from.probes.room.origin"},
           {loop("[1, 2, 3]", "[1, 2]"), "loops[0].from.camera"},
           {loop("\"target\": [4, 5, 6]", "\"up\": [4, 5, 6]"), "loops[0].from.camera"},
           {loop(": 50", ": 0"), "loops[0].from.camera"},
           {loop(": 50", ": 180"), "loops[0].from.camera"},
           {loop(": 60", ": 180"), "loops[0].from.camera"},
           {loop(": 50", ": \"50\""), "loops[0].from.camera"},
           {loop("\"verticalFovDegrees\": 50", "\"angle\": 50"), "loops[0].from.camera"},
           {loop("\"verticalFovDegrees\": 50", "\"verticalFovDegrees\": 50, \"up\": 1"), "loops[0].from.camera"}}) {
    EXPECT_EQ(refused(members), place) << members;
  }
  EXPECT_EQ(refused(loop("2.5", "1")), "");
  EXPECT_EQ(refused(loop("2.5", "20")), "");
  EXPECT_EQ(refused(loop(": 50", ": 179.9")), "");
  EXPECT_EQ(refused(R"("loops": [3])"), "loops[0].");
  const auto loops = [&](std::size_t count) {
    const std::string one = loop().substr(10, loop().size() - 11);
    std::string all = one;
    for (std::size_t i = 1; i < count; ++i) all += ", " + one;
    return refused("\"loops\": [" + all + "]");
  };
  EXPECT_EQ(loops(20), "");
  EXPECT_EQ(loops(21), "loops");
  for (const auto& [text, place] :
       {std::pair("[]", "is not a JSON object"), std::pair("{", "is not a JSON object"), std::pair("{}", "format"),
        std::pair(R"({"format": "boxprobe-lesson-page"})", "version"),
        std::pair(R"({"format": "boxprobe-lesson-page", "version": 2})", "version")}) {
    write("page.json", text);
    EXPECT_THAT(errorText([&] { loadPageWidgets(file("")); }), HasSubstr(std::string("page.json: ") + place + ";"));
  }
}

TEST(PageSketches, AreFoundByTheirNames) {
  for (const PageSketch& sketch : pageSketches()) EXPECT_EQ(findPageSketch(sketch.name), &sketch);
  EXPECT_EQ(findPageSketch("moon"), nullptr);
  EXPECT_TRUE(findPageSketch("cone")->kind == PageSketch::Cone);
  EXPECT_TRUE(findPageSketch("lobe")->kind == PageSketch::Surface);
  EXPECT_TRUE(findPageSketch("sky")->kind == PageSketch::Plan);
}

TEST(Formulas, AreSetByTheirMarkup) {
  const auto set = [](const std::string& text) {
    const std::string mathml = formulaMathml(text);
    EXPECT_EQ(mathml.substr(0, 6) + mathml.substr(mathml.size() - 7), "<mrow></mrow>");
    return mathml.substr(6, mathml.size() - 13);
  };
  EXPECT_EQ(set("a_b^c"), "<msubsup><mi>a</mi><mi>b</mi><mi>c</mi></msubsup>");
  EXPECT_EQ(set("a^c _b d"), "<msubsup><mi>a</mi><mi>b</mi><mi>c</mi></msubsup><mi>d</mi>");
  EXPECT_EQ(set("\\max_i"), "<munder><mi mathvariant=\"normal\">max</mi><mi>i</mi></munder>");
  EXPECT_EQ(set("\\sin_i"), "<msub><mi mathvariant=\"normal\">sin</mi><mi>i</mi></msub>");
  EXPECT_EQ(set("\\min^2"), "<msup><mi mathvariant=\"normal\">min</mi><mn>2</mn></msup>");
  EXPECT_EQ(set("a_"), "<msub><mi>a</mi><mrow></mrow></msub>");
  EXPECT_EQ(set("a_{"), "<msub><mi>a</mi><mrow></mrow></msub>");
  EXPECT_EQ(set("12.5x"), "<mn>12.5</mn><mi>x</mi>");
  EXPECT_EQ(set("R' - P"), "<msup><mi>R</mi><mo>\u2032</mo></msup><mo>\u2212</mo><mi>P</mi>");
  EXPECT_EQ(set("\\sqrt{x}y"), "<msqrt><mrow><mi>x</mi></mrow></msqrt><mi>y</mi>");
  EXPECT_EQ(set("\\sqrt x"), "<msqrt><mi>x</mi></msqrt>");
  EXPECT_EQ(set("\\frac{a}"), "<mfrac><mrow><mi>a</mi></mrow><mrow></mrow></mfrac>");
  EXPECT_EQ(set("\\frac a b"), "<mfrac><mi>a</mi><mi>b</mi></mfrac>");
  EXPECT_EQ(set("\\text{a < b} c"), "<mtext>a &lt; b</mtext><mi>c</mi>");
  EXPECT_EQ(set("\\text c"), "<mtext></mtext><mi>c</mi>");
  EXPECT_EQ(set("\\text{open & wide"), "<mtext>open &amp; wide</mtext>");
  EXPECT_EQ(set("\\text{}x"), "<mtext></mtext><mi>x</mi>");
  EXPECT_EQ(set("\\theta\\cdot \\le\\unknown>"),
            "<mi>\u03b8</mi><mo>\u22c5</mo><mo>\u2264</mo><mtext>\\unknown</mtext><mo>&gt;</mo>");
  EXPECT_EQ(set("a}b"), "<mi>a</mi><mo>}</mo><mi>b</mi>");
  EXPECT_EQ(set("{a}}"), "<mrow><mi>a</mi></mrow><mo>}</mo>");
  EXPECT_EQ(set("\u00e4 \u221e("), "<mo>\u00e4</mo><mo>\u221e</mo><mo>(</mo>");
  EXPECT_EQ(set("  "), "");
  // 32 groups within each other are set, and the text of the next one is shown as it stands.
  const auto nested = [&](int depth) {
    return set(std::string(static_cast<std::size_t>(depth), '{') + "x" +
               std::string(static_cast<std::size_t>(depth), '}'));
  };
  EXPECT_EQ(nested(32).find("<mo>"), std::string::npos);
  EXPECT_THAT(nested(33), HasSubstr("<mo>{</mo><mi>x</mi>"));
  EXPECT_THAT(set(std::string(32, '{') + "\\frac{a}{b}" + std::string(32, '}')), HasSubstr("<mtext>\\frac</mtext>"));
  EXPECT_THAT(set(std::string(31, '{') + "\\frac{a}{b}" + std::string(31, '}')), HasSubstr("<mfrac>"));
}

/// A pixel of a turned box, of which everything is another number.
Explanation oddPixel(double yawDegrees) {
  ExplainedRoom room;
  room.probe.origin = {0.3, 1.1, -0.4};
  room.probe.box = {{-2.0, -0.1, -3.0}, {2.5, 2.7, 2.2}};
  room.probe.rotationDegrees = {0.0, yawDegrees, 0.0};
  room.surface.positionWorld = {0.9, 0.2, 0.5};
  room.surface.eyeWorld = {-0.7, 1.6, 1.3};
  room.surface.normalWorld = glm::normalize(glm::vec3(0.2f, 0.9f, 0.1f));
  room.surface.viewWorld = glm::normalize(glm::vec3(room.surface.eyeWorld - room.surface.positionWorld));
  return room.explain();
}

TEST(Plans, AreThoseOfTheFile) {
  test::KeptValues values;
  for (const double yaw : {0.0, 35.0, 110.0}) {
    const Explanation e = oddPixel(yaw);
    EXPECT_TRUE(hasPlan(e));
    values.part("turned by " + std::to_string(static_cast<int>(yaw)));
    values.add(planJson(e));
    std::string svg = planSvg(e);
    for (std::size_t at = svg.find('>'); at != std::string::npos; at = svg.find('>', at + 2)) svg.insert(at + 1, "\n");
    values.add(svg);
  }
  Explanation e = oddPixel(0.0);
  e.dominant = -1;
  EXPECT_TRUE(hasPlan(e)) << "the first probe is drawn";
  values.add(planJson(e));
  e.surface.normalWorld = glm::vec3(0.0f);
  EXPECT_FALSE(hasPlan(e));
  e = oddPixel(0.0);
  e.probes[0].slabFactors.reset();
  EXPECT_FALSE(hasPlan(e));
  e.probes.clear();
  EXPECT_FALSE(hasPlan(e));
  EXPECT_EQ(planSvg(e), "");
  e = oddPixel(0.0);
  e.hit = false;
  EXPECT_FALSE(hasPlan(e));
  values.expect("unit/values/lesson_plans.txt", 1e-5);
}

class FitNumbers : public TemporaryFolder {};

TEST_F(FitNumbers, AreThoseOfTheFitter) {
  write("room.obj",
        "v -2 0 -1\nv 2 0 -1\nv 2 0 3\nv -2 0 3\nv -2 2 -1\nv 2 2 -1\nv 2 2 3\nv -2 2 3\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const LoadedScene loaded = loadScene(write("room.boxprobe.json", R"({"format": "boxprobe-scene", "version": 1,
    "model": "room.obj", "probes": [
    {"name": "a", "origin": [0.2, 1.1, 0.7], "box": {"min": [-2.4, -0.2, -1.3], "max": [1.8, 2.3, 3.5]}},
    {"name": "b", "origin": [-0.6, 0.9, 1.3], "box": {"min": [-1.8, 0.1, -0.6], "max": [2.3, 2.1, 2.4]}}]})"));
  ProbeFitter fitter(loaded.scene, loaded.models);
  int asked = 0;
  const auto number = [&](const std::string& pointer) {
    return fitNumber(loaded.scene, loaded.models, pointer, [&] { return ++asked > 0; });
  };
  const BoxFit second = fitter.fit(loaded.scene.probes[1]).value();
  const auto same = [&](const std::string& name, double value) {
    const auto measured = number("/probes/1/" + name);
    ASSERT_TRUE(measured) << name;
    EXPECT_EQ(*measured, value) << name;
  };
  same("before/p95Degrees", second.before.p95Degrees);
  same("after/meanDegrees", second.after.meanDegrees);
  same("box/min/2", second.probe.box.min.z);
  same("box/max/1", second.probe.box.max.y);
  same("faces/+z/gainDegrees", second.faces[5].gainDegrees);
  same("faces/+x/sensitivity", second.faces[1].sensitivity);
  same("faces/-z/free", second.faces[4].free ? 1.0 : 0.0);
  const double first = fitter.fit(loaded.scene.probes[0]).value().before.meanDegrees;
  EXPECT_NE(first, second.before.meanDegrees);
  EXPECT_EQ(number("/probes/0/before/meanDegrees"), first);
  EXPECT_GT(asked, 0);
  for (const char* name : {"/probes/2/before/meanDegrees", "/probes/a/before/meanDegrees", "/probes/0/before/above5",
                           "/probes/0/before", "/probes/0/box/min/3", "/probes/0/box/mid/0", "/probes/0/faces/+w/free",
                           "/probe/0/before/meanDegrees", "probes/0/before/meanDegrees", "/probes//before/meanDegrees",
                           "/probes/0/corner/min/0", "/probes/000000/before/meanDegrees"}) {
    EXPECT_FALSE(number(name)) << name;
  }
  EXPECT_FALSE(fitNumber(loaded.scene, loaded.models, "/probes/0/box/min/0", [] { return false; }));
}

TEST(Limits, AreComparedAsTheySay) {
  LessonCondition condition;
  condition.limit = 2.0;
  condition.tolerance = 0.25;
  const auto holds = [&](Comparison comparison, double value, double times = 1.0) {
    condition.comparison = comparison;
    return conditionHolds(condition, value, times);
  };
  EXPECT_TRUE(holds(Comparison::Above, 2.01));
  EXPECT_FALSE(holds(Comparison::Above, 2.0));
  EXPECT_TRUE(holds(Comparison::Below, 1.99));
  EXPECT_FALSE(holds(Comparison::Below, 2.0));
  EXPECT_TRUE(holds(Comparison::Within, 2.25));
  EXPECT_TRUE(holds(Comparison::Within, 1.75));
  EXPECT_FALSE(holds(Comparison::Within, 2.26));
  EXPECT_FALSE(holds(Comparison::Within, 1.74));
  EXPECT_FALSE(holds(Comparison::Above, 3.0 - 1.5, 3.0)) << "without a second measure nothing is multiplied";
  EXPECT_TRUE(holds(Comparison::Above, 2.5, 3.0));
  condition.times = LessonMeasure{};
  EXPECT_EQ(conditionLimit(condition, 3.0), 6.0);
  EXPECT_FALSE(holds(Comparison::Above, 5.9, 3.0));
  EXPECT_TRUE(holds(Comparison::Within, 6.25, 3.0));
  EXPECT_EQ(measuredText(0.31449, ""), "0.314");
  EXPECT_EQ(measuredText(12.345, "\u00b0"), "12.3\u00b0");
  EXPECT_EQ(measuredText(0.5, "m"), "0.5 m");
}

// Of x / (1 + x) with a gamma of 2.2; the region's edges are rounded to pixels, and one pixel is left at least.
TEST(PictureDifferences, AreOfTheirRegion) {
  ImageRgbaF a{4, 3, std::vector<float>(48, 0.0f)}, b = a;
  std::vector<double> squares(12, 0.0);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      a.pixels[4 * i + c] = 0.1f * static_cast<float>(i + c);
      b.pixels[4 * i + c] = 0.07f * static_cast<float>(i * i) + 0.3f * static_cast<float>(c);
      const double x = a.pixels[4 * i + c], y = b.pixels[4 * i + c];
      squares[i] += std::pow(std::pow(x / (1.0 + x), 1.0 / 2.2) - std::pow(y / (1.0 + y), 1.0 / 2.2), 2.0);
    }
    b.pixels[4 * i + 3] = 9.0f;
  }
  const auto expected = [&](const std::vector<std::size_t>& pixels) {
    double sum = 0.0;
    for (const std::size_t i : pixels) sum += squares[i];
    return std::sqrt(sum / (3.0 * static_cast<double>(pixels.size())));
  };
  EXPECT_NEAR(pictureDifference(a, b, {0.0, 0.0, 1.0, 1.0}), expected({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), 1e-6);
  EXPECT_NEAR(pictureDifference(a, b, {0.25, 0.34, 0.75, 1.0}), expected({5, 6, 9, 10}), 1e-6);
  EXPECT_NEAR(pictureDifference(a, b, {0.4, 0.5, 0.9, 0.6}), expected({10, 11}), 1e-6);
  EXPECT_NEAR(pictureDifference(a, b, {0.5, 0.0, 0.5, 0.0}), expected({2}), 1e-6);
  EXPECT_NEAR(pictureDifference(a, b, {1.0, 1.0, 1.0, 1.0}), expected({11}), 1e-6);
}

/// Every texel of every level another.
CubeMap oddCube(int size, int levels) {
  CubeMap cube(size, levels);
  for (int level = 0; level < levels; ++level) {
    const int side = cube.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i < side * side; ++i) {
        const float value = static_cast<float>((37 * i + 101 * face + 53 * level) % 211) / 211.0f;
        cube.setTexel(level, face, i % side, i / side, {value, value * value, 1.0f - value, 1.0f});
      }
    }
  }
  return cube;
}

TEST(OtherMapsValues, AreThoseOfTheFile) {
  test::KeptValues values;
  const CubeMap cube = oddCube(16, 4);
  const auto add = [&](const std::string& name, const glm::vec4& v) {
    values.add(name, std::vector<float>{v.x, v.y, v.z, v.w});
  };
  for (const int width : {4, 2}) {
    const CubeMap fixed = withEdgeFixup(cube, width);
    values.part("edge fix-up over " + std::to_string(width));
    for (int level = 1; level < 4; ++level) {
      const int side = fixed.levelSize(level);
      for (int face = 0; face < 6; ++face) {
        for (int i = face % 2; i < side * side; i += level == 1 ? 5 : 1) {
          add(std::to_string(level) + "/" + std::to_string(face) + "/" + std::to_string(i),
              fixed.texel(level, face, i % side, i / side));
        }
      }
    }
  }
  values.part("within a face");
  for (int i = 0; i < 48; ++i) {
    const float s = -0.99f + 0.041f * static_cast<float>(i), t = 0.97f - 0.0391f * static_cast<float>((i * 7) % 48);
    add(std::to_string(i),
        fetchWithinFace(cube, shading::cubeDirection(i % 6, s, t), -0.3f + 0.081f * static_cast<float>(i)));
  }
  add("of nothing", fetchWithinFace(CubeMap{}, {1.0f, 0.0f, 0.0f}, 0.0f));
  values.expect("unit/values/lesson_maps.txt", 2e-5);
}

}  // namespace
}  // namespace boxprobe
