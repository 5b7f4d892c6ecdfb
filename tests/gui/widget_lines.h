// A tree of widgets as text: of each what it says, what can be set in it, and how its layout places it. No sizes: those
// are the fonts'.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

namespace boxprobe {

/// A line a widget, two blanks a level. `root` too.
std::vector<std::string> widgetLines(const QWidget& root);

/// Does a file of such lines hold here? Another Qt gives layouts other margins of its own.
inline bool widgetLinesHold() {
  return std::string(qVersion()).rfind("5.15", 0) == 0;
}

/// Exactly those of the file (kept_values.h). Least widths follow from the fonts, and count where Qt is Debian 12's.
void expectKeptWidgets(const std::string& file, std::vector<std::string> lines);

}  // namespace boxprobe
