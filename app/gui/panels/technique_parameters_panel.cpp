// See technique_parameters_panel.h.
#include "app/gui/panels/technique_parameters_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/edit/selected_probes.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/table_words.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/technique_parameters.h"

namespace boxprobe {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

/// What an artist sees for a choice of the scene file, and its tool tip; the file's own word where that says enough.
ProbeChoice choiceWords(const ParameterRow& parameter, std::size_t choice) {
  struct Words {
    const char* parameter;
    const char* choice;
    const char* text;
    const char* tip;
  };
  static constexpr Words kWords[] = {
      {"curve", "own", QT_TRANSLATE_NOOP("Choices", "As this probe is filtered"),
       QT_TRANSLATE_NOOP("Choices", "The right one: rough surfaces get the blur that belongs to them")},
      {"curve", "unity", QT_TRANSLATE_NOOP("Choices", "As Unity"),
       QT_TRANSLATE_NOOP("Choices", "To see the difference: the curve that Unity samples its probes by")},
      {"curve", "linear", QT_TRANSLATE_NOOP("Choices", "In proportion"),
       QT_TRANSLATE_NOOP("Choices", "To see the difference: the level in proportion to the roughness")},
      {"curve", "exact", QT_TRANSLATE_NOOP("Choices", "Unity's, exactly"),
       QT_TRANSLATE_NOOP("Choices", "To see the difference: what Unity's curve approximates")},
      {"curve", "marmoset", QT_TRANSLATE_NOOP("Choices", "As Marmoset"),
       QT_TRANSLATE_NOOP("Choices", "To see the difference: Marmoset's curve, blurred sooner")},
      {"curve", "three-level", QT_TRANSLATE_NOOP("Choices", "Three steps of blur"),
       QT_TRANSLATE_NOOP("Choices", "To see the difference: sharp, half and wholly blurred maps, mixed")},
      {"fresnel", "power", QT_TRANSLATE_NOOP("Choices", "By the power above"), ""},
      {"fresnel", "surface", QT_TRANSLATE_NOOP("Choices", "The surface's own"), ""},
      {"sampling", "ggx", QT_TRANSLATE_NOOP("Choices", "Along the surface's lobe"), ""},
      {"sampling", "luminance", QT_TRANSLATE_NOOP("Choices", "Half of them towards what is bright"), ""},
  };
  const auto value = static_cast<int>(choice);
  for (const Words& words : kWords) {
    if (parameter.name != words.parameter || parameter.choices[choice] != words.choice) continue;
    return {QCoreApplication::translate("Choices", words.text), value,
            words.tip[0] == 0 ? QString() : QCoreApplication::translate("Choices", words.tip)};
  }
  return {text(parameter.choices[choice]), value};
}

bool someTechniqueReads(const ParameterRow& parameter) {
  const auto reads = [&](const auto& row) {
    return std::find(row.parameters.begin(), row.parameters.end(), parameter.name) != row.parameters.end();
  };
  return std::any_of(evaluationRows().begin(), evaluationRows().end(), reads) ||
         std::any_of(projectionRows().begin(), projectionRows().end(), reads);
}

QString defaultText(const ParameterRow& p) {
  if (p.kind == ParameterKind::Choice) return choiceWords(p, static_cast<std::size_t>(p.standard)).text;
  if (p.kind == ParameterKind::Switch)
    return p.standard != 0.0 ? QCoreApplication::translate("Choices", "on")
                             : QCoreApplication::translate("Choices", "off");
  return (QString::number(p.standard) + " " + text(p.unit)).trimmed();
}

}  // namespace

TechniqueParametersPanel::TechniqueParametersPanel(Editor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), form_(new QFormLayout(this)) {
  form_->setContentsMargins(0, 0, 0, 0);
  for (const ParameterRow& parameter : parameterRows()) {
    if (!someTechniqueReads(parameter)) continue;
    // For scene files: a picture that rests in the window is refined with it by itself.
    if (parameter.name == "total") continue;
    rows_.push_back(addField(parameter));
    Row& row = rows_.back();
    row.field->setObjectName(text(parameter.name));
    row.label = form_->labelForField(row.field);
    const QString tip = tr("%1 Default: %2.").arg(tableWords(parameter.help), defaultText(parameter));
    row.field->setToolTip(tip);
    row.label->setToolTip(tip);
  }
}

TechniqueParametersPanel::Row TechniqueParametersPanel::addField(const ParameterRow& parameter) {
  if (parameter.kind == ParameterKind::Choice) return addChoice(parameter);
  if (parameter.kind == ParameterKind::Switch) return addSwitch(parameter);
  return addNumber(parameter);
}

TechniqueParametersPanel::Row TechniqueParametersPanel::addNumber(const ParameterRow& p) {
  const int decimals = p.kind == ParameterKind::WholeNumber ? 0 : 3;
  // What rounds to 0 on display would be refused where 0 is: the least number is one that can be shown.
  const double least = p.min > 0.0 ? std::max(p.min, std::pow(10.0, -decimals)) : p.min;
  const ValueField::Format format{least, p.max, p.unit.empty() ? 1.0 : 0.1, decimals,
                                  p.unit.empty() ? QString() : " " + text(p.unit)};
  auto* field = addProbeNumber(editor_, form_, tableWords(p.label), format, tableWords(p.help),
                               [&p](Probe& probe, double value) { setParameter(probe, p, value); });
  return {&p, nullptr, field, [field](double number) { field->show(number); }};
}

TechniqueParametersPanel::Row TechniqueParametersPanel::addChoice(const ParameterRow& p) {
  QVector<ProbeChoice> choices;
  for (std::size_t i = 0; i < p.choices.size(); ++i) choices.push_back(choiceWords(p, i));
  const QString what = tableWords(p.label).toLower();
  QComboBox* combo =
      addProbeChoice(form_, tableWords(p.label), choices, tableWords(p.help), [this, &p, what](int value) {
        editor_.commitProbe(probeEditLabel(editor_, what),
                            [&p, value](Probe& probe) { setParameter(probe, p, value); });
      });
  return {&p, nullptr, combo, [combo](double number) { showChoice(combo, static_cast<int>(number)); }};
}

TechniqueParametersPanel::Row TechniqueParametersPanel::addSwitch(const ParameterRow& p) {
  auto* box = new QCheckBox(this);
  addRow(form_, tableWords(p.label), box);
  const QString what = tableWords(p.label).toLower();
  connect(box, &QCheckBox::clicked, this, [this, &p, what](bool on) {
    editor_.commitProbe(probeEditLabel(editor_, what), [&p, on](Probe& probe) { setParameter(probe, p, on ? 1 : 0); });
  });
  return {&p, nullptr, box, [box](double number) { box->setChecked(number != 0.0); }};
}

void TechniqueParametersPanel::show(const Probe& probe) {
  const SelectedProbes all(editor_);
  const std::vector<const ParameterRow*> used = parametersOf(probeTechnique(probe));
  for (const Row& row : rows_) {
    const bool shown = std::find(used.begin(), used.end(), row.parameter) != used.end();
    row.label->setVisible(shown);
    row.field->setVisible(shown);
    row.show(parameterNumber(probe, *row.parameter));
    showDiffers(row.field, all.differ([&row](const Probe& each) { return parameterNumber(each, *row.parameter); }));
  }
  setVisible(!used.empty());
}

}  // namespace boxprobe
