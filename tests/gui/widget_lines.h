// A tree of widgets as text: of each what it says, what can be set in it, and how its layout places it. No sizes: those
// are the fonts'.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

namespace boxprobe {

/// A line a widget, two blanks a level. `root` too.
std::vector<std::string> widgetLines(const QWidget& root);

/// Do lines that are kept hold here? Another Qt gives layouts other margins of its own, and another Debian widgets
/// other widths, as its fonts ask for. Debian 12 has this one.
inline bool widgetLinesHold() {
  return std::string(qVersion()) == "5.15.8";
}

}  // namespace boxprobe
