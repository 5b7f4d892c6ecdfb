// See panel_layout.h.
#include "app/gui/widgets/panel_layout.h"

#include <QFormLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/widgets/panel_section.h"

namespace boxprobe {

QFormLayout* addSection(QWidget* parent, const QString& title) {
  auto* group = new PanelSection(title, parent);
  auto* form = new QFormLayout(group);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft);
  form->setHorizontalSpacing(10);
  form->setVerticalSpacing(6);
  parent->layout()->addWidget(group);
  return form;
}

void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& toolTip) {
  form->addRow(label, field);
  if (toolTip.isEmpty()) return;
  if (field->toolTip().isEmpty()) field->setToolTip(toolTip);
  if (QWidget* text = form->labelForField(field)) text->setToolTip(toolTip);
}

QToolButton* unfoldButton(QWidget* part, const QString& toolTip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setCheckable(true);
  button->setAutoRaise(true);
  button->setArrowType(Qt::RightArrow);
  button->setToolTip(toolTip);
  part->hide();
  QObject::connect(button, &QToolButton::toggled, part, [button, part](bool shown) {
    button->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    part->setVisible(shown);
  });
  return button;
}

QLabel* helpLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setObjectName("help");
  return label;
}

}  // namespace boxprobe
