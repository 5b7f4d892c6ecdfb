// See lesson_page.h.
#include "app/gui/lessons/lesson_page.h"

#include <QBuffer>
#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <algorithm>
#include <utility>

#include "app/gui/formula/formula_picture.h"
#include "app/gui/lessons/curve_picture.h"
#include "app/lessons/formula_mathml.h"
#include "app/lessons/page_sketches.h"
#include "app/lessons/page_texts.h"
#include "app/lessons/plan_figure.h"
#include "app/web/page_policy.h"
#include "app/web/web_source.h"

namespace boxprobe {

namespace {

constexpr int kJpegQuality = 70;  // some hundred pictures and a room are to stay below 8 MB

std::string html(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

std::string embedded(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "JPEG", kJpegQuality);
  return "data:image/jpeg;base64," + bytes.toBase64().toStdString();
}

char letterOf(std::size_t answer) {
  return static_cast<char>('A' + answer);
}

/// `id`: progress is kept by it.
std::string questionHtml(const LessonQuestion& question, const std::string& id, const PageTexts& say) {
  std::string text = "<fieldset class=\"question\" data-question=\"" + id + "\"><legend>" + html(say("Question")) +
                     "</legend><p>" + html(question.ask) + "</p>";
  for (std::size_t i = 0; i < question.answers.size(); ++i) {
    const LessonAnswer& answer = question.answers[i];
    text += std::string("<details class=\"") + (answer.right ? "right" : "wrong") + "\"><summary>" + letterOf(i) +
            ".&ensp;" + html(answer.text) + "</summary><p>" + html(answer.reply) + "</p></details>";
  }
  return text + "</fieldset>";
}

/// For the end of what is printed, where replies cannot be opened.
std::string answerHtml(const Lesson& lesson, const LessonStep& step) {
  std::string text = "<p><b>" + html(lesson.title) + ", " + html(step.title) + ":</b> ";
  for (std::size_t i = 0; i < step.question->answers.size(); ++i) {
    const LessonAnswer& answer = step.question->answers[i];
    if (answer.right) text += std::string(1, letterOf(i)) + ". " + html(answer.reply);
  }
  return text + "</p>\n";
}

/// The step's address in the page.
std::string stepId(const Lesson& lesson, std::size_t step) {
  return html(lesson.name) + "-" + std::to_string(step + 1);
}

std::string pictureId(const Lesson& lesson, std::size_t step) {
  return stepId(lesson, step) + "-picture";
}

/// "A" of "A. Looks", an appendix, whose lessons are A.1, A.2 and so on; empty for other chapters.
std::string appendixLetter(const std::string& chapter) {
  return chapter.size() > 1 && chapter[1] == '.' && chapter[0] >= 'A' && chapter[0] <= 'Z' ? chapter.substr(0, 1)
                                                                                           : std::string();
}

/// A guess for whoever plans a class: a minute a step, another for its question, more for what is done.
int minutesFor(const Lesson& lesson) {
  constexpr int kTask = 3, kExercise = 4;
  int minutes = 0;
  for (const LessonStep& step : lesson.steps) minutes += 1 + (step.question ? 1 : 0) + (step.task ? kTask : 0);
  return minutes + kExercise * static_cast<int>(lesson.exercises.size());
}

/// Set here, as outlines: few browsers have a font for mathematics, and each sets MathML its own way. Screen readers,
/// and whoever copies it, get the MathML.
std::string mathHtml(const std::string& markup, bool block) {
  const std::string mathml = "<math>" + formulaMathml(markup) + "</math>";
  return std::string("<span class=\"math") + (block ? " math-block" : "") + "\">" + mathml +
         formulaSvg(QString::fromStdString(mathml)).toStdString() + "</span>";
}

/// Formulas that stand beside each other in the window stand one below the other: a column is narrow.
std::string formulaHtml(const std::string& formula) {
  static const std::string between = "\\quad";
  std::string text;
  for (std::size_t from = 0; from < formula.size();) {
    const std::size_t to = std::min(formula.find(between, from), formula.size());
    text += mathHtml(formula.substr(from, to - from), true);
    from = to + between.size();
  }
  return text.empty() ? text : "<div class=\"formula\">" + text + "</div>";
}

/// `measured`: the page measures the task in a plan or a room.
std::string stepHtml(const Lesson& lesson, std::size_t number, const LessonPictures& pictures, bool measured,
                     const PageTexts& say) {
  const LessonStep& step = lesson.steps[number];
  std::string text = "<div class=\"step\" id=\"" + stepId(lesson, number) + "\">";
  // The address of a lesson that was merged into this one.
  if (!step.formerly.empty()) text += "<span id=\"" + html(step.formerly) + "\"></span>";
  text += "<figure";
  if (pictures.sameView[number]) text += " data-before=\"" + pictureId(lesson, number - 1) + "\"";
  text += "><div class=\"picture\">";
  if (step.curve && pictures.curves[number]) {
    text += curveSvg(*step.curve, *pictures.curves[number], lesson.title + ": " + step.title);
  } else {
    text += "<img id=\"" + pictureId(lesson, number) + "\" alt=\"" + html(lesson.title + ": " + step.title) +
            "\" src=\"" + embedded(pictures.steps[number]) + "\">";
  }
  text += "</div></figure><h4><a class=\"address\" title=\"" + html(say("Link to this step")) + "\" href=\"#" +
          stepId(lesson, number) + "\">" + std::to_string(number + 1) + "</a>&ensp;" + html(step.title) + "</h4><p>" +
          html(step.say) + "</p>";
  text += formulaHtml(step.formula);
  // A page has neither panels nor handles.
  if (!step.mayMove.empty()) {
    text +=
        "<p class=\"try\"><b>" + html(say("Try it in the program's window.")) + "</b> " + html(step.mayMove) + "</p>";
  }
  if (step.question) text += questionHtml(*step.question, stepId(lesson, number), say);
  if (step.task) {
    text += "<p class=\"try\"><b>" + html(say("Task.")) + "</b> " + html(step.task->ask) +
            (measured ? " " + html(say("This page measures it, below.")) : "") + "</p>";
  }
  return text + "</div>\n";
}

/// The solution folded.
std::string exercisesHtml(const Lesson& lesson, const LessonPictures& pictures, const PageTexts& say) {
  if (lesson.exercises.empty()) return {};
  std::string text = "<div class=\"exercises\"><h4>" + html(say("Exercises")) + "</h4>\n<ol>\n";
  for (std::size_t i = 0; i < lesson.exercises.size(); ++i) {
    const LessonExercise& exercise = lesson.exercises[i];
    text += "<li>" + html(exercise.ask) + "<details><summary>" + html(say("Solution")) + "</summary><p>" +
            html(exercise.solution) + "</p>" + formulaHtml(exercise.formula);
    if (const auto& measured = pictures.exercises[i]) {
      text += "<p class=\"measured\">" + html(say("Measured:")) + " <b>" + html(measured->measured) + "</b>" +
              (measured->holds ? std::string() : " <span class=\"failed\">" + html(say("does not hold")) + "</span>") +
              "</p>";
    }
    text += "</details></li>\n";
  }
  return text + "</ol></div>\n";
}

/// For the end of what is printed, as the answers.
std::string solutionsHtml(const Lesson& lesson, const PageTexts& say) {
  std::string text;
  for (std::size_t i = 0; i < lesson.exercises.size(); ++i) {
    const LessonExercise& exercise = lesson.exercises[i];
    text += "<p><b>" + html(say("{0}, exercise {1}", {lesson.title, std::to_string(i + 1)})) + ":</b> " +
            html(exercise.solution) + "</p>" + formulaHtml(exercise.formula) + "\n";
  }
  return text;
}

/// Two columns of symbols would be read across on a telephone: one row each.
std::string notationHtml(const std::vector<LessonSymbol>& notation, const PageTexts& say) {
  if (notation.empty()) return {};
  std::string text = "<h2 id=\"notation\">" + html(say("Notation")) + "</h2>\n<table class=\"notation\">\n";
  for (const LessonSymbol& symbol : notation) {
    text +=
        "<tr><th scope=\"row\">" + mathHtml(symbol.symbol, false) + "</th><td>" + html(symbol.means) + "</td></tr>\n";
  }
  return text + "</table>\n";
}

/// Beside what it is done in: the plan or the room. Measured by data/web/task.js.
std::string taskHtml(const Lesson& lesson, const LessonPictures& pictures, const PageTexts& say) {
  if (pictures.task.empty()) return {};
  return "<div class=\"task\" data-task=\"" + html(pictures.task) + "\"><p class=\"try\"><b>" + html(say("Task.")) +
         "</b> " + html(lesson.steps[pictures.taskStep].task->ask) + "</p></div>\n";
}

std::string widgetHtml(const std::string& title, const std::string& text, const std::string& inner,
                       bool opens = false) {
  return std::string("<div class=\"widget") + (opens ? " opens" : "") + "\"><h4>" + html(title) + "</h4>\n<p>" +
         html(text) + "</p>\n" + inner + "</div>\n";
}

std::string planHtml(const Explanation& plan, const std::string& task, const PageTexts& say) {
  return widgetHtml(
      say("The ray in plan and elevation"),
      say("The box is the heavy outline, C the place the cubemap was captured from. The orange ray is what the surface "
          "reflects; the pink arrow is what the cubemap is sampled with, H − C; the dashed grey one is R, sampled "
          "without box projection. With scripts, drag P, the eye, C and the walls."),
      "<div class=\"plan\" data-plan=\"" + html(planJson(plan)) + "\"><div class=\"plan-views\">" + planSvg(plan) +
          "</div></div>\n" + task);
}

std::string roomHtml(const std::string& view, std::size_t scene, const std::string& task, const PageTexts& say) {
  return widgetHtml(
      say("The room, to walk in"),
      say("Drawn in the browser by the program's own shader files: look around, move the walls of the box and the "
          "place the cubemap is captured from, choose technique and roughness. It needs scripts and WebGL2; without "
          "them the pictures above show the same."),
      "<div class=\"room-view\" data-scene=\"scene-" + std::to_string(scene) + "\" data-view=\"" + html(view) +
          "\"></div>\n" + task);
}

/// `attributes`: what it begins with.
std::string figureHtml(const std::string& figure, const std::string& attributes, const PageTexts& say) {
  const std::string still =
      figure == "infinity"
          ? say("This figure needs scripts and WebGL2; pictures of its two ends stand in the lesson on errors.")
          : say("This figure needs scripts.");
  return "<div class=\"figure-live\" data-figure=\"" + figure + "\" " + attributes + "><p class=\"figure-still\">" +
         html(still) + "</p></div>\n";
}

/// What opens the page.
std::string infinityHtml(const std::string& live, const PageTexts& say) {
  return "<section class=\"opening\"><h2 id=\"figure-infinity\">" + html(say("What the box does")) + "</h2>\n<p>" +
         html(say("Most games do not trace a mirror's rays. They look up each ray's direction in six pictures captured "
                  "beforehand from one point C, one for each face of a cube. The six form a cubemap, and a probe "
                  "captures it.")) +
         "</p>\n<p>" +
         html(
             say("This floor is a perfect mirror. Each of its pixels looks up one direction in the cubemap. With R "
                 "alone, the direction in which the ray leaves the floor, it shows what C would see in that direction. "
                 "A box, six planes in place of the walls, tells where the ray ends. Shrink it from infinite to the "
                 "room, and watch the floor.")) +
         "</p>\n" + live + "<p>" +
         html(say("Point at the floor. The orange ray leaves that pixel and ends at what the mirror should show. The "
                  "pink arrow leaves C and ends at what it does show. The cubemap lies beside the room, unfolded: the "
                  "pixel should sample it in the ring, and samples it at the dot.")) +
         "</p></section>\n";
}

std::string standHtml(const std::string& live, const PageTexts& say) {
  return widgetHtml(
      say("Where must you stand?"),
      say("A mirror floor, sampled with R alone. Colours show by how many degrees each of its points misses; black is "
          "right. Find a place for C at which more of the floor is black. Then find the one place at which all of it "
          "is, and move the eye."),
      live);
}

/// The cone, light at a surface, or one of data/web/sketches.js.
std::string sketchHtml(const PageSketch& sketch, const PageTexts& say) {
  const std::string name = sketch.name;
  const std::string live = sketch.kind == PageSketch::Cone ? figureHtml(name, "", say)
                           : sketch.kind == PageSketch::Surface
                               ? figureHtml(name, "data-kind=\"" + name + "\"", say)
                               : figureHtml("sketch", "data-sketch=\"" + name + "\"", say);
  return widgetHtml(say(sketch.title), say(sketch.say), live, sketch.opens);
}

std::string codeHtml(const LessonCode& code, std::size_t scene, const std::string& view, const PageTexts& say) {
  QJsonObject data;
  data["start"] = QString::fromStdString(code.start);
  data["answer"] = QString::fromStdString(code.answer);
  const std::string json = QJsonDocument(data).toJson(QJsonDocument::Compact).toStdString();
  return widgetHtml(say("Write it"),
                    say(code.say) + " " +
                        say("It is compiled as you type, and drawn in the mirror floor. A loop ends after 256 turns."),
                    figureHtml("code",
                               "data-scene=\"scene-" + std::to_string(scene) + "\" data-view=\"" + html(view) +
                                   "\" data-code=\"" + html(json) + "\"",
                               say));
}

std::string sourcesHtml(const std::vector<LessonSource>& sources, const PageTexts& say) {
  if (sources.empty()) return {};
  std::string text = "<h2 id=\"sources\">" + html(say("Sources")) + "</h2>\n<ul>\n";
  for (const LessonSource& source : sources) {
    text += "<li><a href=\"" + html(source.address) + "\">" + html(source.title) + "</a></li>\n";
  }
  return text + "</ul>\n";
}

/// JSON within a script element: it must neither look as if the element ended nor as if a comment began, in which a
/// script's end counts for nothing.
std::string jsonScript(const std::string& id, const QString& json) {
  QString safe = json;
  safe.replace("</", "<\\/").replace("<!", "\\u003c!");
  return "<script type=\"application/json\" id=\"" + id + "\">" + safe.toStdString() + "</script>\n";
}

std::string script(const char* file) {
  return "<script>\n" + std::string(webSource(file)) + "</script>\n";
}

/// For data/web/drawing.js.
std::string textsScript(const PageTexts& say) {
  QJsonObject texts;
  for (const auto& [english, text] : say.all()) texts[QString::fromStdString(english)] = QString::fromStdString(text);
  return jsonScript("page-texts", QString::fromUtf8(QJsonDocument(texts).toJson(QJsonDocument::Compact)));
}

}  // namespace

LessonPage::LessonPage(PageTexts say) : say_(std::move(say)) {}

void LessonPage::addScene(const std::string& path, const std::string& json) {
  sceneTexts_ += jsonScript("scene-" + std::to_string(scenes_.size()), QString::fromStdString(json));
  scenes_.push_back(path);
}

void LessonPage::addLoop(const LessonLoop& loop, const std::string& webm) {
  const std::string say = say_(loop.say);
  const QByteArray bytes = QByteArray::fromRawData(webm.data(), static_cast<int>(webm.size()));
  loops_ += "<figure class=\"loop\"><video controls loop muted playsinline aria-label=\"" + html(say) +
            "\" src=\"data:video/webm;base64," + bytes.toBase64().toStdString() + "\"></video><figcaption>" +
            html(say) + "</figcaption></figure>\n";
}

void LessonPage::add(const Lesson& lesson, const LessonPictures& pictures, const PageWidgets& widgets) {
  Section section{lesson.name, lesson.title, lesson.chapter, "", minutesFor(lesson)};
  std::string& text = section.html;
  if (!lesson.unreviewed.empty()) text += "<p class=\"try\">" + html(lesson.unreviewed) + "</p>\n";
  text += "<p>" + html(lesson.summary) + "</p>";
  const auto scene = std::find(scenes_.begin(), scenes_.end(), lesson.scene);
  const auto& rooms = widgets.rooms;
  const bool hasRoom = scene != scenes_.end() && std::find(rooms.begin(), rooms.end(), lesson.name) != rooms.end();
  const auto place = static_cast<std::size_t>(scene - scenes_.begin());
  std::string after;
  for (const auto& [figure, of] : widgets.figures) {
    if (std::find(of.begin(), of.end(), lesson.name) == of.end()) continue;
    if (const PageSketch* sketch = findPageSketch(figure)) {
      (sketch->opens ? text : after) += sketchHtml(*sketch, say_);
    } else if (hasRoom) {
      const std::string& view = figure == "infinity" ? pictures.firstView : pictures.view;
      const std::string live = figureHtml(
          figure, "data-scene=\"scene-" + std::to_string(place) + "\" data-view=\"" + html(view) + "\"", say_);
      if (figure == "infinity") opening_ = infinityHtml(live, say_);
      if (figure == "stand") after += standHtml(live, say_);  // it answers the steps' questions
    }
  }
  if (const auto code = widgets.code.find(lesson.name); code != widgets.code.end() && hasRoom) {
    after += codeHtml(code->second, place, pictures.firstView, say_);
  }
  text += "<div class=\"steps\">\n";
  const std::string task = hasRoom || pictures.plan ? taskHtml(lesson, pictures, say_) : std::string();
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    text += stepHtml(lesson, i, pictures, !task.empty() && i == pictures.taskStep, say_);
    if (lesson.steps[i].question) answers_ += answerHtml(lesson, lesson.steps[i]);
  }
  text += "</div>\n" + after + loops_;
  loops_.clear();
  if (pictures.plan) text += planHtml(*pictures.plan, hasRoom ? std::string() : task, say_);
  if (hasRoom) text += roomHtml(pictures.view, place, task, say_);
  text += "<div class=\"measured\">";
  if (!pictures.claims.empty()) text += "<h4>" + html(say_("Measured")) + "</h4>";
  for (const LessonPictures::Claim& claim : pictures.claims) {
    text += "<p>" + html(claim.say) + " <b>" + html(claim.measured) + "</b>" +
            (claim.holds ? std::string() : " <span class=\"failed\">" + html(say_("does not hold")) + "</span>") +
            "</p>";
  }
  text += "</div>\n" + exercisesHtml(lesson, pictures, say_);
  // Another language than the page's head is said.
  const std::string opened = lesson.language != say_.language() ? "<section lang=\"" + html(lesson.language) + "\">\n"
                                                                : std::string("<section>\n");
  section.html = opened + "<h3 id=\"" + html(lesson.name) + "\">@NUMBER@" + html(lesson.title) + "</h3>" + text;
  solutions_ += solutionsHtml(lesson, say_);
  sections_.push_back(std::move(section));
}

std::vector<std::string> LessonPage::numbers() const {
  std::vector<std::string> result;
  std::string chapter;
  int lessons = 0, appended = 0;
  for (const Section& section : sections_) {
    const std::string letter = html(appendixLetter(section.chapter));
    if (section.chapter != chapter) appended = 0;
    chapter = section.chapter;
    result.push_back(letter.empty() ? std::to_string(++lessons) : letter + "." + std::to_string(++appended));
  }
  return result;
}

std::string LessonPage::contents() const {
  const std::vector<std::string> numbered = numbers();
  std::string text, chapter;
  int chapters = 0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& section = sections_[i];
    if (i == 0 || section.chapter != chapter) {
      chapter = section.chapter;
      int minutes = 0;
      for (const Section& other : sections_) minutes += other.chapter == chapter ? other.minutes : 0;
      text += (i > 0 ? "</ul></li>\n" : "") + std::string("<li><a href=\"#chapter-") + std::to_string(++chapters) +
              "\">" + html(chapter) + "</a> <span class=\"minutes\">" +
              html(say_("{0} min", {std::to_string(minutes)})) + "</span><ul>\n";
    }
    text +=
        "<li>" + numbered[i] + "&ensp;<a href=\"#" + html(section.name) + "\">" + html(section.title) + "</a></li>\n";
  }
  return text + (sections_.empty() ? "" : "</ul></li>\n");
}

std::string LessonPage::body() const {
  std::string text, chapter;
  const std::vector<std::string> numbered = numbers();
  int chapters = 0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& section = sections_[i];
    if (i == 0 || section.chapter != chapter) {
      chapter = section.chapter;
      text += "<h2 id=\"chapter-" + std::to_string(++chapters) + "\">" + html(chapter) + "</h2>\n";
    }
    const std::string before = sections_.size() > 1 ? numbered[i] + "&ensp;" : std::string();
    const std::string mark = "@NUMBER@";
    std::string whole = section.html;
    const std::size_t at = whole.find(mark);
    whole.replace(at, mark.size(), before);
    const std::size_t end = whole.find("</h3>", at);
    whole.insert(
        end, " <span class=\"minutes\">" + html(say_("about {0} min", {std::to_string(section.minutes)})) + "</span>");
    text += whole;
    const auto link = [](const Section& to, const char* left, const char* right) {
      return "<a href=\"#" + html(to.name) + "\">" + left + html(to.title) + right + "</a>";
    };
    if (sections_.size() > 1) {
      text += "<p class=\"lesson-nav\">" + (i > 0 ? link(sections_[i - 1], "&larr;&ensp;", "") : "<span></span>") +
              "<a href=\"#contents\">" + html(say_("Contents")) + "</a>" +
              (i + 1 < sections_.size() ? link(sections_[i + 1], "", "&ensp;&rarr;") : "<span></span>") + "</p>";
    }
    text += "</section>\n";
  }
  return text;
}

std::string LessonPage::text(const std::vector<LessonSymbol>& notation,
                             const std::vector<LessonSource>& sources) const {
  const std::string title = html(say_("Box projection, taught by doing"));
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"" + html(say_.language()) +
      "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>" +
      title + "</title>\n<style>\n" + std::string(webSource("page.css")) + "</style></head><body>\n<h1>" + title +
      "</h1>\n<main>\n" + opening_;
  // What the opening needs stands beside it, so that its figure is alive while the rest is still read.
  if (!say_.all().empty()) text += textsScript(say_);
  text += script("drawing.js");
  if (!scenes_.empty()) text += sceneTexts_ + script("room.js") + script("figures.js");
  if (!opening_.empty()) {
    text += "<script>boxprobeOpen(document.querySelector('[data-figure=infinity]'));</script>\n";
  }
  if (!say_.unreviewed().empty()) text += "<p class=\"try\">" + html(say_.unreviewed()) + "</p>\n";
  int minutes = 0;
  for (const Section& section : sections_) minutes += section.minutes;
  const std::vector<std::string> values = {std::to_string(sections_.size()), std::to_string(minutes)};
  const std::string inAll =
      sections_.size() > 1 ? html(say_("{0} lessons, about {1} minutes in all.", values)) + " " : std::string();
  text +=
      "<p>" +
      html(say_("Boxprobe drew every picture from the lesson's scene and measured every number on it when it made "
                "this page. In its window you can change each step yourself:")) +
      " <code>boxprobe lessons NAME</code></p>\n<p>" + inAll +
      html(say_("The page works without a network and sends nothing; your answers are kept in this browser alone.")) +
      "</p>\n<nav id=\"contents\" aria-label=\"" + html(say_("Contents")) +
      "\"><p class=\"score\"></p><ul class=\"chapters\">\n" + contents();
  if (!notation.empty()) text += "<li><a href=\"#notation\">" + html(say_("Notation")) + "</a></li>\n";
  if (!sources.empty()) text += "<li><a href=\"#sources\">" + html(say_("Sources")) + "</a></li>\n";
  text += "</ul></nav>\n" + body() + notationHtml(notation, say_) + sourcesHtml(sources, say_);
  const auto atTheEnd = [&](const char* heading, const std::string& what) {
    if (what.empty()) return;
    text += "<section class=\"answers\"><h2>" + html(say_(heading)) + "</h2>\n" + what + "</section>\n";
  };
  atTheEnd("Answers", answers_);
  atTheEnd("Solutions", solutions_);
  text += "</main>\n<footer><p>" +
          html(say_("Lessons, pictures and scripts of this page: Boxprobe {0}, BSD 3-Clause License, copyright 2026 "
                    "Boxprobe contributors.",
                    {BOXPROBE_VERSION})) +
          "</p></footer>\n";
  if (!scenes_.empty()) text += script("code.js");
  for (const char* file : {"cone.js", "surface.js", "sketch.js", "plane.js", "sketches.js", "sketches_more.js",
                           "plan.js", "task.js", "page.js"}) {
    text += script(file);
  }
  // All of it stands in the page. Formulas and figures have styles of their own, as attributes, which have no hashes.
  return withPolicy(text + "</body></html>\n",
                    {"", "", "style-src-attr 'unsafe-inline'; img-src data:; media-src data:; connect-src data:; "});
}

}  // namespace boxprobe
