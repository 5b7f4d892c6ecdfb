// See vector_row.h.
#include "app/gui/widgets/vector_row.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPalette>

#include "app/gui/widgets/axis_colors.h"
#include "app/gui/widgets/scrub_label.h"
#include "app/gui/widgets/window_style.h"

namespace boxprobe {

VectorRow::VectorRow(const ValueField::Format& format, const QString& toolTip, QWidget* parent, const QString& names)
    : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (int axis = 0; axis < 3; ++axis) {
    const QString name = names.mid(axis, 1);
    auto* field = new ValueField(format, this);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);  // three in a row: the room is for digits
    field->setMinimumWidth(80);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    field->setToolTip(name + ": " + toolTip);
    auto* label = new ScrubLabel(name, field, this);
    label->setToolTip(tr("Drag sideways to change %1; hold Shift for fine steps").arg(name));
    label->setBuddy(field);
    labels_[static_cast<std::size_t>(axis)] = label;
    field->setAccessibleName(name);
    layout->addWidget(label);
    layout->addWidget(field, 1);
    connect(field, &ValueField::previewed, this, [this, axis](double value) { emit previewed(axis, value); });
    connect(field, &ValueField::committed, this, [this, axis](double value) { emit committed(axis, value); });
    fields_[static_cast<std::size_t>(axis)] = field;
  }
  colorNames();
}

void VectorRow::setName(const QString& name) {
  for (std::size_t axis = 0; axis < fields_.size(); ++axis) {
    fields_[axis]->setAccessibleName(name + " " + labels_[axis]->text());
  }
}

void VectorRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorNames();
}

// The handles' colours, as dark or light as text must be.
void VectorRow::colorNames() {
  const QColor ground = palette().color(QPalette::Window);
  for (int axis = 0; axis < 3; ++axis) {
    const QColor color = readable(axisColor(axis), ground);
    labels_[static_cast<std::size_t>(axis)]->setStyleSheet(
        QString("QLabel { color: %1; font-weight: bold; }").arg(color.name()));
  }
}

void VectorRow::show(const glm::dvec3& value) {
  for (int axis = 0; axis < 3; ++axis) field(axis)->show(value[axis]);
}

}  // namespace boxprobe
