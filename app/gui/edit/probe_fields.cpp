// See probe_fields.h.
#include "app/gui/edit/probe_fields.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QSignalBlocker>

#include "app/gui/edit/field_form.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/quiet_combo.h"

namespace boxprobe {

QString probeEditLabel(const Editor& editor, const QString& what) {
  return editor.probe() ? Editor::tr("Set %1 of %2").arg(what, editor.selectedName()) : QString();
}

ValueField* addProbeNumber(Editor& editor, QFormLayout* form, const QString& label, const ValueField::Format& format,
                           const QString& toolTip, const std::function<void(Probe&, double value)>& edit) {
  auto* field = new ValueField(format, form->parentWidget());
  addRow(form, label, field, toolTip);
  const QString what = label.toLower();
  QObject::connect(field, &ValueField::previewed, field, [&editor, field, what, edit](double value) {
    editor.previewProbe({field}, probeEditLabel(editor, what), [=](Probe& probe) { edit(probe, value); });
  });
  QObject::connect(field, &ValueField::committed, field, [&editor, field, what, edit](double value) {
    editor.commitProbe({field}, probeEditLabel(editor, what), [=](Probe& probe) { edit(probe, value); });
  });
  return field;
}

QComboBox* addProbeChoice(QFormLayout* form, const QString& label, const QVector<ProbeChoice>& choices,
                          const QString& toolTip, const std::function<void(int value)>& chosen) {
  auto* combo = new QuietCombo(form->parentWidget());
  for (const ProbeChoice& choice : choices) {
    combo->addItem(choice.text, choice.value);
    if (!choice.toolTip.isEmpty()) combo->setItemData(combo->count() - 1, choice.toolTip, Qt::ToolTipRole);
  }
  addRow(form, label, combo, toolTip);
  QObject::connect(combo, QOverload<int>::of(&QComboBox::activated), combo,
                   [combo, chosen] { chosen(combo->currentData().toInt()); });
  return combo;
}

void showChoice(QComboBox* combo, int value, const QString& pattern) {
  const QSignalBlocker quiet(combo);
  if (combo->findData(value) < 0) combo->addItem(pattern.arg(value), value);
  combo->setCurrentIndex(combo->findData(value));
}

void showDiffers(QWidget* field, bool differ) {
  if (auto* number = dynamic_cast<ValueField*>(field)) {
    number->setDiffers(differ);
  } else if (auto* combo = dynamic_cast<QuietCombo*>(field)) {
    combo->setDiffers(differ);
  } else if (auto* box = dynamic_cast<QCheckBox*>(field)) {
    box->setTristate(differ);
    if (differ) box->setCheckState(Qt::PartiallyChecked);
  }
}

void showNothing(QWidget* panel, bool nothing) {
  const auto fields = panel->findChildren<QWidget*>();
  for (QWidget* field : fields) {
    if (auto* box = qobject_cast<QCheckBox*>(field)) {
      box->setTristate(false);
      if (nothing) box->setChecked(false);
    } else {
      showDiffers(field, nothing);
    }
  }
}

QVector<ProbeChoice> choicesOf(const FieldInfo& field, const QStringList& names) {
  QVector<ProbeChoice> choices;
  for (int i = 0; i < names.size(); ++i) choices.push_back({names[i], i, choiceTip(field, i)});
  return choices;
}

}  // namespace boxprobe
