// See lesson_page.h.
#include "app/gui/lessons/lesson_page.h"

#include <QBuffer>
#include <QByteArray>
#include <QString>

#include "app/lessons/formula_mathml.h"

namespace boxprobe {

namespace {

constexpr int kJpegQuality = 88;

// Plain: it must read well on a projector, on paper and on a telephone.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Box projection, taught by doing</title><style>
body{font:17px/1.5 system-ui,sans-serif;color:#1d2126;max-width:1180px;margin:0 auto;padding:1.5rem}
h1{font-size:2rem}h2{margin-top:3rem;border-bottom:2px solid #d8dde3}h3{margin:2.5rem 0 .2rem;font-size:1.5rem}
h4{margin:.6rem 0 .2rem}.steps{display:grid;grid-template-columns:repeat(auto-fit,minmax(320px,1fr));gap:1.4rem}
.steps img{width:100%;display:block;border-radius:4px}.steps p{margin:.3rem 0}math{font-size:1.15em}
.formula{margin:.6rem 0;overflow-x:auto}.try{color:#7a4b00}.measured{color:#39424c;font-size:.92em}
.failed{color:#b00020;font-weight:bold}details{margin:.2rem 0}summary{cursor:pointer}
.right{color:#0a6b2d}.wrong{color:#9a2a00}nav ul{columns:2;padding-left:1.2rem}@media print{h3{break-before:page}}
</style></head><body>
<h1>Box projection, taught by doing</h1>
<p>Every picture was drawn by Boxprobe from the lesson's scene, every number measured on it when this page was made.
In the window each step can be taken hold of: <code>boxprobe lessons NAME</code>.</p>
)";

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

std::string questionHtml(const LessonQuestion& question) {
  std::string text = "<p><b>Question.</b> " + html(question.ask) + "</p>";
  for (const LessonAnswer& answer : question.answers) {
    text += "<details><summary>" + html(answer.text) + "</summary><p class=\"" + (answer.right ? "right" : "wrong") +
            "\">" + html(answer.reply) + "</p></details>";
  }
  return text;
}

std::string stepHtml(const LessonStep& step, std::size_t number, const QImage& picture) {
  std::string text = "<div><img alt=\"" + html(step.title) + "\" src=\"" + embedded(picture) + "\"><h4>" +
                     std::to_string(number + 1) + "&ensp;" + html(step.title) + "</h4><p>" + html(step.say) + "</p>";
  if (!step.formula.empty()) {
    text += "<div class=\"formula\"><math display=\"block\">" + formulaMathml(step.formula) + "</math></div>";
  }
  if (!step.mayMove.empty()) text += "<p class=\"try\"><b>Try it.</b> " + html(step.mayMove) + "</p>";
  if (step.question) text += questionHtml(*step.question);
  if (step.task) text += "<p class=\"try\"><b>Task.</b> " + html(step.task->ask) + "</p>";
  return text + "</div>\n";
}

}  // namespace

void LessonPage::add(const Lesson& lesson, const LessonPictures& pictures) {
  if (lesson.chapter != chapter_) {
    chapter_ = lesson.chapter;
    body_ += "<h2>" + html(chapter_) + "</h2>\n";
  }
  contents_ += "<li><a href=\"#" + html(lesson.name) + "\">" + html(lesson.title) + "</a></li>\n";
  const bool own = lesson.language != "en";  // than the page's head
  if (own) body_ += "<section lang=\"" + html(lesson.language) + "\">\n";
  body_ += "<h3 id=\"" + html(lesson.name) + "\">" + html(lesson.title) + "</h3><p>" + html(lesson.summary) +
           "</p><div class=\"steps\">\n";
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) body_ += stepHtml(lesson.steps[i], i, pictures.steps[i]);
  body_ += "</div>\n<div class=\"measured\">";
  for (const LessonPictures::Claim& claim : pictures.claims) {
    body_ += "<p>" + html(claim.say) + " <b>" + html(claim.measured) + "</b>" +
             (claim.holds ? "" : " <span class=\"failed\">does not hold</span>") + "</p>";
  }
  body_ += own ? "</div>\n</section>\n" : "</div>\n";
}

std::string LessonPage::text() const {
  return kHead + ("<nav><ul>\n" + contents_) + "</ul></nav>\n" + body_ + "</body></html>\n";
}

}  // namespace boxprobe
