// See lesson_page.h.
#include "app/gui/lessons/lesson_page.h"

#include <QBuffer>
#include <QByteArray>
#include <QString>
#include <algorithm>

#include "app/lessons/formula_mathml.h"
#include "app/lessons/plan_figure.h"
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

std::string questionHtml(const LessonQuestion& question) {
  std::string text = "<fieldset class=\"question\"><legend>Question</legend><p>" + html(question.ask) + "</p>";
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

std::string pictureId(const Lesson& lesson, std::size_t step) {
  return html(lesson.name) + "-" + std::to_string(step + 1);
}

/// Formulas that stand beside each other in the window stand one below the other: a column is narrow.
std::string formulaHtml(const std::string& formula) {
  static const std::string between = "\\quad";
  std::string text;
  for (std::size_t from = 0; from < formula.size();) {
    const std::size_t to = std::min(formula.find(between, from), formula.size());
    text += "<math display=\"block\">" + formulaMathml(formula.substr(from, to - from)) + "</math>";
    from = to + between.size();
  }
  return text.empty() ? text : "<div class=\"formula\">" + text + "</div>";
}

/// `measured`: the page measures the task in a plan or a room.
std::string stepHtml(const Lesson& lesson, std::size_t number, const LessonPictures& pictures, bool measured) {
  const LessonStep& step = lesson.steps[number];
  std::string text = "<div class=\"step\"><figure";
  if (pictures.sameView[number]) text += " data-before=\"" + pictureId(lesson, number - 1) + "\"";
  text += "><div class=\"picture\"><img id=\"" + pictureId(lesson, number) + "\" alt=\"" + html(step.title) +
          "\" src=\"" + embedded(pictures.steps[number]) + "\"></div></figure><h4>" + std::to_string(number + 1) +
          "&ensp;" + html(step.title) + "</h4><p>" + html(step.say) + "</p>";
  text += formulaHtml(step.formula);
  // A page has neither panels nor handles.
  if (!step.mayMove.empty()) {
    text += "<p class=\"try\"><b>Try it in the program's window.</b> " + html(step.mayMove) + "</p>";
  }
  if (step.question) text += questionHtml(*step.question);
  if (step.task) {
    text += "<p class=\"try\"><b>Task.</b> " + html(step.task->ask) +
            (measured ? " This page measures it, below." : "") + "</p>";
  }
  return text + "</div>\n";
}

/// The solution folded.
std::string exercisesHtml(const Lesson& lesson, const LessonPictures& pictures) {
  if (lesson.exercises.empty()) return {};
  std::string text = "<div class=\"exercises\"><h4>Exercises</h4>\n<ol>\n";
  for (std::size_t i = 0; i < lesson.exercises.size(); ++i) {
    const LessonExercise& exercise = lesson.exercises[i];
    text += "<li>" + html(exercise.ask) + "<details><summary>Solution</summary><p>" + html(exercise.solution) + "</p>" +
            formulaHtml(exercise.formula);
    if (const auto& measured = pictures.exercises[i]) {
      text += "<p class=\"measured\">Measured: <b>" + html(measured->measured) + "</b>" +
              (measured->holds ? "" : " <span class=\"failed\">does not hold</span>") + "</p>";
    }
    text += "</details></li>\n";
  }
  return text + "</ol></div>\n";
}

/// For the end of what is printed, as the answers.
std::string solutionsHtml(const Lesson& lesson) {
  std::string text;
  for (std::size_t i = 0; i < lesson.exercises.size(); ++i) {
    const LessonExercise& exercise = lesson.exercises[i];
    text += "<p><b>" + html(lesson.title) + ", exercise " + std::to_string(i + 1) + ":</b> " + html(exercise.solution) +
            "</p>" + formulaHtml(exercise.formula) + "\n";
  }
  return text;
}

/// Two columns of symbols would be read across on a telephone: one row each.
std::string notationHtml(const std::vector<LessonSymbol>& notation) {
  if (notation.empty()) return {};
  std::string text = "<h2 id=\"notation\">Notation</h2>\n<table class=\"notation\">\n";
  for (const LessonSymbol& symbol : notation) {
    text += "<tr><th scope=\"row\"><math>" + formulaMathml(symbol.symbol) + "</math></th><td>" + html(symbol.means) +
            "</td></tr>\n";
  }
  return text + "</table>\n";
}

/// Beside what it is done in: the plan or the room. Measured by data/web/task.js.
std::string taskHtml(const Lesson& lesson, const std::string& task) {
  const auto step =
      std::find_if(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& s) { return s.task.has_value(); });
  if (task.empty() || step == lesson.steps.end()) return {};
  return "<div class=\"task\" data-task=\"" + html(task) + "\"><p class=\"try\"><b>Task.</b> " + html(step->task->ask) +
         "</p></div>\n";
}

std::string planHtml(const Explanation& plan, const std::string& task) {
  return "<div class=\"widget\"><h4>The ray in plan and elevation</h4>\n"
         "<p>The box is the heavy outline, C the place the cubemap was captured from. The orange ray is what the "
         "surface reflects; the pink arrow is what the cubemap is sampled with, H &minus; C; the dashed grey one is R, "
         "sampled without box projection. With scripts, drag P, the eye, C and the walls.</p>\n"
         "<div class=\"plan\" data-plan=\"" +
         html(planJson(plan)) + "\"><div class=\"plan-views\">" + planSvg(plan) + "</div></div>\n" + task + "</div>\n";
}

std::string roomHtml(const std::string& view, std::size_t scene, const std::string& task) {
  return "<div class=\"widget\"><h4>The room, to walk in</h4><p>Drawn in the browser by the program's own shader "
         "files: look around, move the walls of the box and the place the cubemap is captured from, choose technique "
         "and "
         "roughness. It needs scripts and WebGL2; without them the pictures above show the same.</p>\n"
         "<div class=\"room-view\" data-scene=\"scene-" +
         std::to_string(scene) + "\" data-view=\"" + html(view) + "\"></div>\n" + task + "</div>\n";
}

std::string script(const char* file) {
  return "<script>\n" + std::string(webSource(file)) + "</script>\n";
}

}  // namespace

void LessonPage::addScene(const std::string& path, const std::string& json) {
  // In a script element the text must not look as if the element ended.
  const QString safe = QString::fromStdString(json).replace("</", "<\\/");
  sceneTexts_ += "<script type=\"application/json\" id=\"scene-" + std::to_string(scenes_.size()) + "\">" +
                 safe.toStdString() + "</script>\n";
  scenes_.push_back(path);
}

void LessonPage::addLoop(const LessonLoop& loop, const std::string& webm) {
  const std::string& say = loop.say;
  const QByteArray bytes = QByteArray::fromRawData(webm.data(), static_cast<int>(webm.size()));
  loops_ += "<figure class=\"loop\"><video controls loop muted playsinline aria-label=\"" + html(say) +
            "\" src=\"data:video/webm;base64," + bytes.toBase64().toStdString() + "\"></video><figcaption>" +
            html(say) + "</figcaption></figure>\n";
}

void LessonPage::add(const Lesson& lesson, const LessonPictures& pictures, bool room) {
  if (lesson.chapter != chapter_) {
    chapter_ = lesson.chapter;
    body_ += "<h2>" + html(chapter_) + "</h2>\n";
  }
  contents_ += "<li><a href=\"#" + html(lesson.name) + "\">" + html(lesson.title) + "</a></li>\n";
  // Another language than the page's head is said.
  body_ += lesson.language != "en" ? "<section lang=\"" + html(lesson.language) + "\">\n" : std::string("<section>\n");
  if (!lesson.unreviewed.empty()) body_ += "<p class=\"try\">" + html(lesson.unreviewed) + "</p>\n";
  body_ += "<h3 id=\"" + html(lesson.name) + "\">" + html(lesson.title) + "</h3><p>" + html(lesson.summary) +
           "</p><div class=\"steps\">\n";
  const auto scene = std::find(scenes_.begin(), scenes_.end(), lesson.scene);
  const bool hasRoom = room && scene != scenes_.end();
  const std::string task = hasRoom || pictures.plan ? taskHtml(lesson, pictures.task) : std::string();
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    body_ += stepHtml(lesson, i, pictures, !task.empty());
    if (lesson.steps[i].question) answers_ += answerHtml(lesson, lesson.steps[i]);
  }
  body_ += "</div>\n" + loops_;
  loops_.clear();
  if (pictures.plan) body_ += planHtml(*pictures.plan, hasRoom ? std::string() : task);
  if (hasRoom) {
    body_ += roomHtml(pictures.view, static_cast<std::size_t>(scene - scenes_.begin()), task);
  }
  body_ += "<div class=\"measured\">";
  if (!pictures.claims.empty()) body_ += "<h4>Measured</h4>";
  for (const LessonPictures::Claim& claim : pictures.claims) {
    body_ += "<p>" + html(claim.say) + " <b>" + html(claim.measured) + "</b>" +
             (claim.holds ? "" : " <span class=\"failed\">does not hold</span>") + "</p>";
  }
  body_ += "</div>\n" + exercisesHtml(lesson, pictures) + "</section>\n";
  solutions_ += solutionsHtml(lesson);
}

std::string LessonPage::text(const std::vector<LessonSymbol>& notation) const {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Box projection, taught by doing</title>\n<style>\n" +
      std::string(webSource("page.css")) +
      "</style></head><body>\n<h1>Box projection, taught by doing</h1>\n"
      "<p>Every picture was drawn by Boxprobe from the lesson's scene, every number measured on it when this page was "
      "made. In the window each step can be taken hold of: <code>boxprobe lessons NAME</code>.</p>\n"
      "<p class=\"score\" aria-live=\"polite\"></p>\n<nav><ul>\n" +
      contents_ + (notation.empty() ? "" : "<li><a href=\"#notation\">Notation</a></li>\n") + "</ul></nav>\n" + body_ +
      notationHtml(notation);
  if (!answers_.empty()) text += "<section class=\"answers\"><h2>Answers</h2>\n" + answers_ + "</section>\n";
  if (!solutions_.empty()) text += "<section class=\"answers\"><h2>Solutions</h2>\n" + solutions_ + "</section>\n";
  if (!scenes_.empty()) text += sceneTexts_ + script("room.js");
  return text + script("plan.js") + script("task.js") + script("page.js") + "</body></html>\n";
}

}  // namespace boxprobe
