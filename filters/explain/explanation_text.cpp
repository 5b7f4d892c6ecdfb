// See explanation_text.h.
#include "filters/explain/explanation_text.h"

#include <algorithm>
#include <array>

#include "filters/core/base/one_line.h"

namespace boxprobe {

namespace {

struct Widths {
  std::size_t symbol = 0;
  std::array<std::size_t, 3> number{};
  std::size_t unit = 0;
};

/// One set of columns for the whole text, so that the numbers of all sections align.
Widths columnWidths(const std::vector<ExplanationSection>& sections) {
  Widths widths;
  for (const ExplanationSection& section : sections) {
    for (const ExplanationRow& row : section.rows) {
      widths.symbol = std::max(widths.symbol, row.symbol.english().size() + (row.detail ? 2 : 0));
      widths.unit = std::max(widths.unit, row.unit.size());
      for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        widths.number.at(i) = std::max(widths.number.at(i), row.numbers[i].size());
      }
    }
  }
  return widths;
}

void append(std::string& line, const std::string& text, std::size_t width, bool right) {
  const std::string gap(width > text.size() ? width - text.size() : 0, ' ');
  line += right ? gap + text : text + gap;
  line += "  ";
}

std::string rowText(const ExplanationRow& row, const Widths& widths) {
  std::string line = row.marked ? "  > " : "    ";
  append(line, (row.detail ? "  " : "") + row.symbol.english(), widths.symbol, false);
  for (std::size_t i = 0; i < widths.number.size(); ++i) {
    append(line, i < row.numbers.size() ? row.numbers[i] : "", widths.number[i], true);
  }
  append(line, row.unit, widths.unit, false);
  line += row.meaning.english();
  if (row.marked) line += "   <- the smallest";
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string explanationText(const Explanation& e, const ExplanationDetail& detail,
                            const std::optional<Verdict>& verdict) {
  const std::vector<ExplanationSection> sections = explanationSections(e, detail);
  const Widths widths = columnWidths(sections);
  std::string text;
  if (verdict) {
    text += oneLine(verdict->sentence.english()) + "\n";
    if (verdict->mend) text += "Mend: " + oneLine(verdict->mend->words.english()) + "\n";
    text += "\n";
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i > 0) text += "\n";
    text += oneLine(sections[i].title.english()) + "\n";
    if (i == 0) {
      for (const Phrase& note : e.notes) text += "  ! " + oneLine(note.english()) + "\n";
    }
    for (const ExplanationRow& row : sections[i].rows) text += rowText(row, widths);
  }
  return text;
}

}  // namespace boxprobe
