// The techniques to choose from, one item a row of projectionRows() times a row of evaluationRows(): the table decides
// what is here, nothing in this file knows a technique by name. Called by the probe panel; knows no document.
#pragma once

#include <string>

#include "app/gui/quiet_combo.h"

namespace boxprobe {

class TechniqueCombo : public QuietCombo {
  Q_OBJECT

 public:
  explicit TechniqueCombo(QWidget* parent = nullptr);

  void show(const std::string& techniqueId);
  /// What the current technique does, in a line or two.
  QString help() const;

 signals:
  /// Shortest id that parses back.
  void chosen(const std::string& techniqueId);
};

}  // namespace boxprobe
