// Fields that edit the selected probe, ready connected to the editor: a number, a choice. Called by the panels.
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>
#include <QVector>
#include <functional>

#include "app/gui/edit/editor.h"
#include "app/gui/widgets/value_field.h"
#include "filters/core/scene/scene_field.h"

class QComboBox;
class QFormLayout;
class QWidget;

namespace boxprobe {

/// "Set near of room", "Set near of 3 probes": the undo step of a field.
QString probeEditLabel(const Editor& editor, const QString& what);

ValueField* addProbeNumber(Editor& editor, QFormLayout* form, const QString& label, const ValueField::Format& format,
                           const QString& toolTip, const std::function<void(Probe&, double value)>& edit);

struct ProbeChoice {
  QString text;
  int value;  ///< item data
  QString toolTip = {};
};
/// A combo box whose choice calls `chosen` with the item's value.
QComboBox* addProbeChoice(QFormLayout* form, const QString& label, const QVector<ProbeChoice>& choices,
                          const QString& toolTip, const std::function<void(int value)>& chosen);
/// Shows a value of the document; one that is not among the choices joins them as `pattern` says ("%1").
void showChoice(QComboBox* combo, int value, const QString& pattern = "%1");

/// Says of a field of the selected probes that they do not agree in it: a ValueField, a combo box made here or a check
/// box that shows the value of one of them already.
void showDiffers(QWidget* field, bool differ);

/// Where no probe is selected: the fields of `panel` have dashes for values and no tick. `nothing` false ends that.
void showNothing(QWidget* panel, bool nothing);

/// Choices of a field by its row, under the names a form shows, in the order of the ids.
QVector<ProbeChoice> choicesOf(const FieldInfo& field, const QStringList& names);

}  // namespace boxprobe
