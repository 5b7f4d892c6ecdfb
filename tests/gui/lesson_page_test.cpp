// The page of lessons as it is written, line by line, against lesson_page.txt: every kind of step, figure and question
// in it. Pictures, outlines of formulas and what stands in files of data/web are left out.
#include "app/gui/lessons/lesson_page.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/support/kept_values.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

/// Each text needs escaping, none is like another.
std::string pageWords(const std::string& what) {
  return what + " <&\"> " + std::to_string(what.size());
}

QImage smallPicture() {
  QImage image(8, 5, QImage::Format_RGB888);
  image.fill(Qt::white);
  return image;
}

LessonStep stepNamed(const std::string& name) {
  LessonStep made;
  made.title = pageWords(name);
  made.say = pageWords("say of " + name);
  return made;
}

/// Steps of every kind.
Lesson fullLesson() {
  Lesson lesson;
  lesson.name = "full<1>";
  lesson.title = pageWords("Full");
  lesson.chapter = "Boxes & walls";
  lesson.summary = pageWords("summary");
  lesson.scene = "hall.boxprobe.json";
  for (const char* name : {"first", "asks", "task", "second task", "curve", "curve unmeasured", "moved"}) {
    lesson.steps.push_back(stepNamed(name));
  }
  lesson.steps[0].formula = "H = P + d R \\quad d = 2";
  lesson.steps[1].question = LessonQuestion{pageWords("which"),
                                            {{pageWords("no"), false, pageWords("why not")},
                                             {pageWords("yes"), true, pageWords("why")},
                                             {"maybe", false, "?"}}};
  lesson.steps[2].mayMove = pageWords("a face");
  lesson.steps[2].task = LessonTask{pageWords("make it fit"), "m", {}, "praise", {}, {}};
  lesson.steps[3].task = LessonTask{pageWords("again"), "m", {}, "praise", {}, {}};
  lesson.steps[4].curve.emplace();
  lesson.steps[4].curve->values = {1, 4, 8};
  lesson.steps[5].curve = lesson.steps[4].curve;
  lesson.steps[6].formerly = "old&lesson";
  lesson.exercises.push_back({pageWords("how far"), pageWords("so far"), "P", "m", {}});
  lesson.exercises.push_back({pageWords("how near"), pageWords("so near"), "", "", {}});
  lesson.exercises.push_back({pageWords("how wide"), pageWords("so wide"), "", "", {}});
  return lesson;
}

LessonPictures picturesOf(const Lesson& lesson) {
  LessonPictures pictures;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    pictures.steps.push_back(smallPicture());
    pictures.curves.emplace_back();
    pictures.sameView.push_back(i == 2 || i == 6);
  }
  pictures.exercises.resize(lesson.exercises.size());
  pictures.view = "{\"view\": \"task\"}";
  pictures.firstView = "{\"view\": \"first\"}";
  return pictures;
}

LessonPictures fullPictures(const Lesson& lesson) {
  LessonPictures pictures = picturesOf(lesson);
  pictures.curves[4] = CurvePoints{{0.3, 0.2, 0.1}, {}, {}};
  pictures.task = "{\"task\": \"<&>\"}";
  pictures.taskStep = 3;
  pictures.claims = {{pageWords("claim"), pageWords("0.21"), true},
                     {pageWords("false claim"), pageWords("0.22"), false}};
  pictures.exercises[0] = LessonPictures::Claim{"", pageWords("0.31"), true};
  pictures.exercises[2] = LessonPictures::Claim{"", pageWords("0.32"), false};
  return pictures;
}

Lesson shortLesson(const std::string& name, const std::string& chapter, int steps) {
  Lesson lesson;
  lesson.name = name;
  lesson.title = "The " + name;
  lesson.chapter = chapter;
  lesson.summary = "Of " + name;
  lesson.scene = "yard.boxprobe.json";
  for (int i = 0; i < steps; ++i) lesson.steps.push_back(stepNamed(name + " " + std::to_string(i)));
  return lesson;
}

/// One line for each element that begins a line of the page; without what is kept elsewhere.
std::vector<std::string> pageLines(const std::string& page) {
  QString text = QString::fromStdString(page);
  const auto without = [&text](const char* pattern, const char* instead) {
    text.replace(QRegularExpression(pattern, QRegularExpression::DotMatchesEverythingOption), instead);
  };
  without("<script>\n.*?</script>", "<script>...</script>");
  without("<style>.*?</style>", "<style>...</style>");
  without("<svg aria-hidden=.*?</svg>", "<svg of a formula>");
  without("<div class=\"plan-views\">.*?</div>", "<div of views>");
  without("data-plan=\".*?\"", "data-plan=\"...\"");
  without("data:image/jpeg;base64,[A-Za-z0-9+/=]+", "JPEG");
  without("'sha256-[^']*'", "HASH");
  without("Boxprobe [0-9][^,]*,", "Boxprobe VERSION,");
  text.replace(
      QRegularExpression("(<(?:p|div|figure|h[1-4]|details|fieldset|legend|li|ul|ol|table|tr|span id|svg class|"
                         "text|path|circle|script|meta)[ >])"),
      "\n\\1");
  std::vector<std::string> lines;
  for (const QString& line : text.split('\n')) {
    if (!line.trimmed().isEmpty()) lines.push_back(line.trimmed().toStdString());
  }
  return lines;
}

TEST(LessonPageText, HasEveryKindOfStepFigureAndQuestionAsBefore) {
  std::vector<std::string> lines;
  const auto keep = [&lines](const std::string& heading, const LessonPage& page,
                             const std::vector<LessonSymbol>& notation, const std::vector<LessonSource>& sources) {
    lines.push_back("== " + heading);
    for (const std::string& line : pageLines(page.text(notation, sources))) lines.push_back(line);
  };

  PageWidgets widgets;
  widgets.rooms = {"full<1>", "other"};
  widgets.figures = {
      {"infinity", {"full<1>"}}, {"stand", {"full<1>", "plain"}}, {"cone", {"full<1>"}}, {"fresnel", {"full<1>"}},
      {"lobe", {"plain"}},       {"ball", {"plain", "full<1>"}},  {"glass", {"nobody"}}};
  widgets.code["full<1>"] = {pageWords("write"), "a = 1;", "a = \"2\";"};
  widgets.code["plain"] = {"not without a room", "", ""};
  const Lesson full = fullLesson();
  {
    LessonPage page;
    page.addScene("yard.boxprobe.json", "{\"yard\": \"</script><!--\"}");
    page.addScene("hall.boxprobe.json", "{\"hall\": 1}");
    LessonLoop loop;
    loop.say = pageWords("to and fro");
    page.addLoop(loop, std::string("webm\0film", 9));
    page.add(full, fullPictures(full), widgets);
    Lesson plain = shortLesson("plain", "Boxes & walls", 2);
    plain.unreviewed = pageWords("nobody read this");
    plain.language = "de";
    plain.steps[1].question = LessonQuestion{"q", {{"r", true, "s"}}};
    LessonPictures pictures = picturesOf(plain);
    ExplainedRoom room;
    pictures.plan = room.explain();
    pictures.task = "{\"in\": \"the plan\"}";
    pictures.taskStep = 1;
    plain.steps[1].task = LessonTask{"in the plan", "m", {}, "", {}, {}};
    page.add(plain, pictures, widgets);
    const Lesson other = shortLesson("other", "Light", 1);
    page.add(other, picturesOf(other), widgets);
    for (const auto& [name, chapter, steps] : {std::tuple("glow", "A. Looks", 3),
                                               {"haze", "A. Looks", 1},
                                               {"fog", "B. More", 2},
                                               {"dust", "a. No letter", 5}}) {
      const Lesson lesson = shortLesson(name, chapter, steps);
      page.add(lesson, picturesOf(lesson), widgets);
    }
    keep("all", page, {{"P", pageWords("a point")}, {"t_x", "a distance"}},
         {{pageWords("source"), "https://x.org/?a&b"}, {"T", "U"}});
  }
  {
    LessonPage page;
    const Lesson alone = shortLesson("alone", "C", 1);
    page.add(alone, picturesOf(alone), {});
    keep("one lesson", page, {}, {});
  }
  {
    // A room whose scene was not added has none; its task stands in its plan.
    LessonPage page;
    LessonPictures pictures = fullPictures(full);
    page.add(full, pictures, widgets);
    keep("without its scene", page, {}, {});
  }
  {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir("page");
    QFile file(folder.filePath("page/xx.json"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": "boxprobe-lesson-page-text", "version": 1, "language": "xx", "unreviewed": "<not> read",
      "texts": {"Question": "<Q>", "Task.": "T & T.", "Contents": "<C>", "about {0} min": "{0} m.", "Answers": "AA",
      "{0} lessons, about {1} minutes in all.": "{1} m for {0} lessons", "Measured": "MM", "{0} min": "{0} <m>",
      "{0}, exercise {1}": "{1} of {0}"}})");
    file.close();
    LessonPage page(PageTexts(folder.path().toStdString(), "xx"));
    page.add(full, fullPictures(full), {});
    Lesson same = shortLesson("same", "C", 2);
    same.language = "xx";
    page.add(same, picturesOf(same), {});
    keep("in another language", page, {}, {});
  }
  keep("empty", LessonPage(), {}, {});
  test::expectKeptValues("gui/values/lesson_page.txt", lines, test::kExactly);
}

}  // namespace
}  // namespace boxprobe
