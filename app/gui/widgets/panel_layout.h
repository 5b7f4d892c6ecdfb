// How the panels look: titled sections, rows of label and field, a part that unfolds. Called by the panels.
#pragma once

#include <QString>

class QFormLayout;
class QLabel;
class QToolButton;
class QWidget;

namespace boxprobe {

/// A titled group with a form in it, added to `parent`'s vertical layout.
QFormLayout* addSection(QWidget* parent, const QString& title);

/// A row whose label has the field's tool tip and, clicked, gives it the focus.
void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& toolTip = {});

/// An arrow that shows and hides `part`, which is hidden at first.
QToolButton* unfoldButton(QWidget* part, const QString& toolTip, QWidget* parent);

/// A small, wrapping line of explanation.
QLabel* helpLabel(QWidget* parent);

}  // namespace boxprobe
