// The parameters of the selected probe's technique: a field for each row of parameterRows() that some technique reads,
// of which those of the chosen one are shown. The table decides what is here; nothing in this file knows a technique or
// a parameter by name. Called by the probe panel.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/math/technique/parameter_table.h"

class QFormLayout;

namespace boxprobe {

class TechniqueParametersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TechniqueParametersPanel(Editor& editor, QWidget* parent = nullptr);

  void show(const Probe& probe);

 private:
  struct Row {
    const ParameterRow* parameter;
    QWidget* label;
    QWidget* field;
    std::function<void(double number)> show;
  };

  /// Makes the field, edits included; each named as the scene file names the parameter.
  Row addField(const ParameterRow& parameter);
  Row addNumber(const ParameterRow& parameter);
  Row addChoice(const ParameterRow& parameter);
  Row addSwitch(const ParameterRow& parameter);

  Editor& editor_;
  QFormLayout* form_;
  std::vector<Row> rows_;
};

}  // namespace boxprobe
