// See lesson_page.h.
#include "app/gui/lessons/lesson_page.h"

#include <QBuffer>
#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <algorithm>

#include "app/gui/formula/formula_picture.h"
#include "app/gui/lessons/curve_picture.h"
#include "app/lessons/formula_mathml.h"
#include "app/lessons/plan_figure.h"
#include "app/session/program_name.h"
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
std::string questionHtml(const LessonQuestion& question, const std::string& id) {
  std::string text = "<fieldset class=\"question\" data-question=\"" + id + "\"><legend>Question</legend><p>" +
                     html(question.ask) + "</p>";
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
std::string stepHtml(const Lesson& lesson, std::size_t number, const LessonPictures& pictures, bool measured) {
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
  text += "</div></figure><h4><a class=\"address\" href=\"#" + stepId(lesson, number) + "\">" +
          std::to_string(number + 1) + "</a>&ensp;" + html(step.title) + "</h4><p>" + html(step.say) + "</p>";
  text += formulaHtml(step.formula);
  // A page has neither panels nor handles.
  if (!step.mayMove.empty()) {
    text += "<p class=\"try\"><b>Try it in the program's window.</b> " + html(step.mayMove) + "</p>";
  }
  if (step.question) text += questionHtml(*step.question, stepId(lesson, number));
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
    text +=
        "<tr><th scope=\"row\">" + mathHtml(symbol.symbol, false) + "</th><td>" + html(symbol.means) + "</td></tr>\n";
  }
  return text + "</table>\n";
}

/// Beside what it is done in: the plan or the room. Measured by data/web/task.js.
std::string taskHtml(const Lesson& lesson, const LessonPictures& pictures) {
  if (pictures.task.empty()) return {};
  return "<div class=\"task\" data-task=\"" + html(pictures.task) + "\"><p class=\"try\"><b>Task.</b> " +
         html(lesson.steps[pictures.taskStep].task->ask) + "</p></div>\n";
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

/// `attributes`: what it begins with.
std::string figureHtml(const std::string& figure, const std::string& attributes) {
  const char* const still =
      figure == "infinity"
          ? "This figure needs scripts and WebGL2; pictures of its two ends stand in the lesson on errors."
          : "This figure needs scripts.";
  return "<div class=\"figure-live\" data-figure=\"" + figure + "\" " + attributes + "><p class=\"figure-still\">" +
         still + "</p></div>\n";
}

/// What opens the page.
std::string infinityHtml(const std::string& live) {
  return "<section class=\"opening\"><h2 id=\"figure-infinity\">What the box does</h2>\n"
         "<p>This floor is a perfect mirror. Each of its pixels samples one cubemap, captured at C. Shrink the "
         "probe's box from infinite to the room, and watch the floor.</p>\n" +
         live +
         "<p>Point at the floor. The orange ray leaves that pixel and ends at what the mirror should show. The pink "
         "arrow leaves C and ends at what it does show. The cubemap lies beside the room, unfolded: the pixel should "
         "sample it in the ring, and samples it at the dot.</p></section>\n";
}

std::string standHtml(const std::string& live) {
  return "<div class=\"widget\"><h4>Where must you stand?</h4>\n<p>A mirror floor, sampled with R alone. Colours show "
         "by "
         "how many degrees each of its points misses; black is right. Find a place for C at which more of the floor "
         "is black. Then find the one place at which all of it is, and move the eye.</p>\n" +
         live + "</div>\n";
}

std::string coneHtml() {
  return "<div class=\"widget\"><h4>From cone to texels</h4>\n<p>The ray from P is reflected to the wall, and a rough "
         "floor spreads it into a cone. The cone meets a patch of the wall (orange). C sees the patch under another "
         "angle (pink), and so another mip level is right. Which one, when P is near the wall and when it is far? Draw "
         "it into the chart before you look.</p>\n" +
         figureHtml("cone", "") +
         "<p>The level is one part of the error. The other is the lobe's shape, long and narrow where the view is "
         "flat, "
         "which no level can give: see what was measured on the pictures.</p></div>\n";
}

std::string surfaceHtml(const std::string& kind) {
  const char* const title = kind == "fresnel" ? "How much is reflected"
                            : kind == "lobe"  ? "Where a rough surface sends its light"
                                              : "Reflected and let in";
  const char* const say = kind == "fresnel" ? "Drag the eye down to the surface. The arrows are as long as the shares "
                                              "of light they carry: orange is reflected, pink is let in. How far down "
                                              "must the eye be until half is reflected?"
                          : kind == "lobe"  ? "Drag the eye and change the roughness. The lobe is GGX with Smith's "
                                              "term, in the plane of the eye. Is it brightest in "
                                              "the mirrored direction?"
                                            : "Drag the eye, and change the index of refraction. From within the glass "
                                              "there is an angle beyond which nothing gets out. "
                                              "Find it for n = 1.5.";
  return "<div class=\"widget\"><h4>" + std::string(title) + "</h4>\n<p>" + say + "</p>\n" +
         figureHtml(kind, "data-kind=\"" + kind + "\"") + "</div>\n";
}

std::string codeHtml(const LessonCode& code, std::size_t scene, const std::string& view) {
  QJsonObject data;
  data["start"] = QString::fromStdString(code.start);
  data["answer"] = QString::fromStdString(code.answer);
  const std::string json = QJsonDocument(data).toJson(QJsonDocument::Compact).toStdString();
  return "<div class=\"widget\"><h4>Write it</h4>\n<p>" + html(code.say) +
         " It is compiled as you type, and drawn in the mirror floor. A loop ends after 256 turns.</p>\n" +
         figureHtml("code", "data-scene=\"scene-" + std::to_string(scene) + "\" data-view=\"" + html(view) +
                                "\" data-code=\"" + html(json) + "\"") +
         "</div>\n";
}

std::string sourcesHtml(const std::vector<LessonSource>& sources) {
  if (sources.empty()) return {};
  std::string text = "<h2 id=\"sources\">Sources</h2>\n<ul>\n";
  for (const LessonSource& source : sources) {
    text += "<li><a href=\"" + html(source.address) + "\">" + html(source.title) + "</a></li>\n";
  }
  return text + "</ul>\n";
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
    if (figure == "cone") {
      text += coneHtml();
    } else if (figure == "fresnel" || figure == "lobe" || figure == "glass") {
      after += surfaceHtml(figure);
    } else if (hasRoom) {
      const std::string& view = figure == "infinity" ? pictures.firstView : pictures.view;
      const std::string live =
          figureHtml(figure, "data-scene=\"scene-" + std::to_string(place) + "\" data-view=\"" + html(view) + "\"");
      if (figure == "infinity") opening_ = infinityHtml(live);
      if (figure == "stand") after += standHtml(live);  // it answers the steps' questions
    }
  }
  if (const auto code = widgets.code.find(lesson.name); code != widgets.code.end() && hasRoom) {
    after += codeHtml(code->second, place, pictures.firstView);
  }
  text += "<div class=\"steps\">\n";
  const std::string task = hasRoom || pictures.plan ? taskHtml(lesson, pictures) : std::string();
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    text += stepHtml(lesson, i, pictures, !task.empty() && i == pictures.taskStep);
    if (lesson.steps[i].question) answers_ += answerHtml(lesson, lesson.steps[i]);
  }
  text += "</div>\n" + after + loops_;
  loops_.clear();
  if (pictures.plan) text += planHtml(*pictures.plan, hasRoom ? std::string() : task);
  if (hasRoom) text += roomHtml(pictures.view, place, task);
  text += "<div class=\"measured\">";
  if (!pictures.claims.empty()) text += "<h4>Measured</h4>";
  for (const LessonPictures::Claim& claim : pictures.claims) {
    text += "<p>" + html(claim.say) + " <b>" + html(claim.measured) + "</b>" +
            (claim.holds ? "" : " <span class=\"failed\">does not hold</span>") + "</p>";
  }
  text += "</div>\n" + exercisesHtml(lesson, pictures);
  // Another language than the page's head is said.
  const std::string opened =
      lesson.language != "en" ? "<section lang=\"" + html(lesson.language) + "\">\n" : std::string("<section>\n");
  section.html = opened + "<h3 id=\"" + html(lesson.name) + "\">@NUMBER@" + html(lesson.title) + "</h3>" + text;
  solutions_ += solutionsHtml(lesson);
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
              "\">" + html(chapter) + "</a> <span class=\"minutes\">" + std::to_string(minutes) + " min</span><ul>\n";
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
    whole.insert(end, " <span class=\"minutes\">about " + std::to_string(section.minutes) + " min</span>");
    text += whole;
    const auto link = [](const Section& to, const char* left, const char* right) {
      return "<a href=\"#" + html(to.name) + "\">" + left + html(to.title) + right + "</a>";
    };
    if (sections_.size() > 1) {
      text += "<p class=\"lesson-nav\">" + (i > 0 ? link(sections_[i - 1], "&larr;&ensp;", "") : "<span></span>") +
              "<a href=\"#contents\">Contents</a>" +
              (i + 1 < sections_.size() ? link(sections_[i + 1], "", "&ensp;&rarr;") : "<span></span>") + "</p>";
    }
    text += "</section>\n";
  }
  return text;
}

std::string LessonPage::text(const std::vector<LessonSymbol>& notation,
                             const std::vector<LessonSource>& sources) const {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Box projection, taught by doing</title>\n<style>\n" +
      std::string(webSource("page.css")) + "</style></head><body>\n<h1>Box projection, taught by doing</h1>\n<main>\n" +
      opening_ +
      "<p>Boxprobe drew every picture from the lesson's scene and measured every number on it when it made this page. "
      "In its window you can change each step yourself: <code>boxprobe lessons NAME</code>.</p>\n"
      "<nav id=\"contents\" aria-label=\"Contents\"><p class=\"score\"></p><ul "
      "class=\"chapters\">\n" +
      contents() + (notation.empty() ? "" : "<li><a href=\"#notation\">Notation</a></li>\n") +
      (sources.empty() ? "" : "<li><a href=\"#sources\">Sources</a></li>\n") + "</ul></nav>\n" + body() +
      notationHtml(notation);
  if (!answers_.empty()) text += "<section class=\"answers\"><h2>Answers</h2>\n" + answers_ + "</section>\n";
  if (!solutions_.empty()) text += "<section class=\"answers\"><h2>Solutions</h2>\n" + solutions_ + "</section>\n";
  text += sourcesHtml(sources) + "</main>\n<footer><p>Lessons, pictures and scripts of this page: " + kProgramName +
          ", BSD 3-Clause License, copyright 2026 Boxprobe contributors.</p></footer>\n";
  text += script("drawing.js");
  if (!scenes_.empty()) text += sceneTexts_ + script("room.js") + script("figures.js") + script("code.js");
  return text + script("cone.js") + script("surface.js") + script("plan.js") + script("task.js") + script("page.js") +
         "</body></html>\n";
}

}  // namespace boxprobe
