// See explanation_html.h.
#include "app/gui/explain/explanation_html.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <cstdint>

#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/window_style.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

QString accent() {
  return styleColor(StyleColor::Accent).name();
}
constexpr int kColumns = 5;  ///< symbol, three numbers, swatch

QString numberHtml(const std::string& number) {
  return phraseWords(numberPhrase(number)).toHtmlEscaped().replace('-', QString::fromUtf8("\u2212"));
}

QString cell(const QString& content, const QString& attributes = {}) {
  return "<td " + attributes + ">" + content + "</td>";
}

/// As the picture shows light.
struct Display {
  double exposure;
  Tone tone;
};

QString swatchCell(const ExplanationRow& row, const Display& display) {
  if (!row.color) return cell({});
  return cell("&nbsp;",
              "width=\"26\" bgcolor=\"" + displayColor(*row.color, display.exposure, display.tone).name() + "\"");
}

QString small(const QString& html) {
  return QString("<span style=\"color:%1; font-size:small\">%2</span>").arg(styleColor(StyleColor::Dim).name(), html);
}

QString rowHtml(const ExplanationRow& row, const Display& display) {
  const QString background =
      row.marked ? QString(" bgcolor=\"%1\"").arg(styleColor(StyleColor::Deciding).name()) : QString();
  QString html = "<tr" + background + ">";
  QString symbol = row.detail ? small(phraseWords(row.symbol).toHtmlEscaped()) : symbolHtml(row.symbol);
  if (row.sum) symbol = "<b>" + symbol + "</b>";
  html += cell(symbol, row.detail ? "align=\"right\"" : "");
  const QString mark = QString(" <b style=\"color:%1\">%2</b>")
                           .arg(accent(), QCoreApplication::translate("ExplanationHtml", "smallest"));
  const QString meaning = small(formulaHtml(phraseWords(row.meaning)) + (row.marked ? mark : QString()));
  // One number leaves room for what it means beside it; three have it below.
  if (row.numbers.size() < 3) {
    if (row.numbers.empty()) {
      html += cell(meaning, "colspan=\"3\"") + swatchCell(row, display);
    } else {
      html += cell(numberHtml(row.numbers[0]), "align=\"right\"") + cell(meaning, "colspan=\"3\"");
    }
    return html + "</tr>";
  }
  for (const std::string& number : row.numbers) {
    const QString text = row.detail ? small(numberHtml(number)) : numberHtml(number);
    html += cell(row.sum ? "<b>" + text + "</b>" : text, "align=\"right\"");
  }
  html += swatchCell(row, display) + "</tr>";
  if (!row.meaning.empty()) {
    html += "<tr>" + cell(small("&emsp;&emsp;&emsp;") + meaning, QString("colspan=\"%1\"").arg(kColumns)) + "</tr>";
  }
  return html;
}

QString noteHtml(const Phrase& note) {
  return QString(
             "<table width=\"100%\" cellpadding=\"6\" cellspacing=\"0\"><tr><td bgcolor=\"%3\">"
             "<b style=\"color:%1\">!</b>&nbsp; %2</td></tr></table>")
      .arg(accent(), phraseWords(note).toHtmlEscaped(), styleColor(StyleColor::Remarkable).name());
}

}  // namespace

QColor displayColor(const glm::vec3& linear, double exposure, Tone tone) {
  const std::array<std::uint8_t, 3> shown = displayBytes(linear, exposure, tone);
  return {shown[0], shown[1], shown[2]};
}

QString symbolHtml(const Phrase& symbol) {
  const QString text = QString::fromStdString(symbol.english());
  // A word is a name, a letter is a symbol.
  const int underscore = text.indexOf('_');
  const QString letter = underscore < 0 ? text : text.left(underscore);
  const bool word = letter.size() > 1 && letter.contains(QRegularExpression("^[a-z0-9 ]+$"));
  if (word) return phraseWords(symbol).toHtmlEscaped();
  QString html = letter.toHtmlEscaped();
  html.replace("N.V", QString::fromUtf8("N\u00b7V")).replace("E/pi", QString::fromUtf8("E/\u03c0"));
  html.replace(" - ", QString::fromUtf8(" \u2212 "));
  html = "<span style=\"font-family:serif; font-style:italic\">" + html + "</span>";
  if (underscore >= 0) html += "<sub>" + text.mid(underscore + 1).toHtmlEscaped() + "</sub>";
  return html;
}

QString formulaHtml(const QString& text) {
  QString html = text.toHtmlEscaped();
  html.replace(" - ", QString::fromUtf8(" \u2212 "));
  html.replace("(-", QString::fromUtf8("(\u2212")).replace("/ -", QString::fromUtf8("/ \u2212"));
  html.replace("^2", "<sup>2</sup>");
  for (const char* name : {"t_x", "t_y", "t_z", "F_0", "F_90"}) html.replace(name, symbolHtml(Phrase::plain(name)));
  html.replace("alpha", QString::fromUtf8("<i>\u03b1</i>"));
  return html;
}

QString explanationHtml(const Explanation& e, const ExplanationDetail& detail, double exposure, Tone tone) {
  const std::vector<ExplanationSection> sections = explanationSections(e, detail);
  // One table for all: numbers of all sections stand under each other.
  QStringList parts = {"<table width=\"100%\" cellpadding=\"1\" cellspacing=\"0\">"};
  const auto wide = [](const QString& content) {
    return QString("<tr><td colspan=\"%1\">%2</td></tr>").arg(kColumns).arg(content);
  };
  for (std::size_t i = 0; i < sections.size(); ++i) {
    parts += wide(QString("<p style=\"margin-top:7px; margin-bottom:2px\"><b style=\"color:%1\">%2</b></p>")
                      .arg(accent(), phraseWords(sections[i].title).toHtmlEscaped()));
    if (i == 0) {
      for (const Phrase& note : e.notes) parts += wide(noteHtml(note));
    }
    for (const ExplanationRow& row : sections[i].rows) parts += rowHtml(row, {exposure, tone});
  }
  parts += "</table><p>" +
           small(QCoreApplication::translate(
               "ExplanationHtml",
               "Lengths in scene units, directions without, colours linear; swatches as the picture shows them.")) +
           "</p>";
  return parts.join(QString());
}

}  // namespace boxprobe
