// Named values of widgets, a line each: what tests of values compare with a file.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "tests/gui/widget_lines.h"

namespace boxprobe {

class ValueLines {
 public:
  void add(const std::string& name, const QString& text) { lines_.push_back(name + ": " + oneLine(text)); }
  void add(const std::string& name, double value) { add(name, QString::number(value, 'g', 5)); }
  void tree(const std::string& name, const QWidget& root) {
    lines_.push_back("== " + name);
    for (const std::string& line : widgetLines(root)) lines_.push_back(line);
  }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  static std::string oneLine(QString text) { return text.replace('\n', "|").toStdString(); }
  std::vector<std::string> lines_;
};

}  // namespace boxprobe
