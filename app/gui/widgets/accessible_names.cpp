// See accessible_names.h.
#include "app/gui/widgets/accessible_names.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSlider>
#include <utility>

#include "app/gui/widgets/vector_row.h"

namespace boxprobe {

namespace {

bool isControl(const QWidget* widget) {
  if (qobject_cast<const QScrollBar*>(widget) != nullptr) return false;
  if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
    return qobject_cast<const QAbstractSpinBox*>(line->parent()) == nullptr &&
           qobject_cast<const QComboBox*>(line->parent()) == nullptr;
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) return button->text().isEmpty();
  return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QAbstractSlider*>(widget) != nullptr;
}

/// Its first sentence, without markup.
QString firstSentence(QString tip) {
  static const QRegularExpression kMarkup("<[^>]*>"), kEnd("[.:;](\\s|$)");
  tip.remove(kMarkup);
  tip = tip.section('\n', 0, 0);
  const int end = tip.indexOf(kEnd);
  return (end > 0 ? tip.left(end) : tip).simplified();
}

QString labelText(const QFormLayout& form, int row) {
  QLayoutItem* item = form.itemAt(row, QFormLayout::LabelRole);
  const auto* label = item != nullptr ? qobject_cast<const QLabel*>(item->widget()) : nullptr;
  QString text = label != nullptr ? label->text().remove('&').trimmed() : QString();
  if (text.endsWith(':')) text.chop(1);
  return text;
}

void nameRow(const QString& name, QWidget* field) {
  if (auto* vector = qobject_cast<VectorRow*>(field)) return vector->setName(name);
  QList<QWidget*> controls = field->findChildren<QWidget*>();
  controls.prepend(field);
  QWidget* first = nullptr;
  for (QWidget* control : std::as_const(controls)) {
    if (!isControl(control) || !control->accessibleName().isEmpty()) continue;
    const QString tip = firstSentence(control->toolTip());
    control->setAccessibleName(
        first == nullptr || tip.isEmpty() || tip == firstSentence(first->toolTip()) ? name : name + ": " + tip);
    if (first == nullptr) first = control;
  }
}

/// Of Qt's own buttons, which have neither text nor tip.
QString ownName(const QWidget& widget) {
  static constexpr std::pair<const char*, const char*> kNames[] = {
      {"qt_menubar_ext_button", QT_TRANSLATE_NOOP("AccessibleNames", "More menus")},
      {"qt_toolbar_ext_button", QT_TRANSLATE_NOOP("AccessibleNames", "More tools")},
      {"qt_dockwidget_closebutton", QT_TRANSLATE_NOOP("AccessibleNames", "Close")},
      {"qt_dockwidget_floatbutton", QT_TRANSLATE_NOOP("AccessibleNames", "Float")}};
  for (const auto& [object, name] : kNames) {
    if (widget.objectName() == object) return QCoreApplication::translate("AccessibleNames", name);
  }
  if (qobject_cast<const QLineEdit*>(widget.parent()) != nullptr) {
    return QCoreApplication::translate("AccessibleNames", "Clear");
  }
  return {};
}

QString fallbackName(const QWidget& widget) {
  if (const QString tip = firstSentence(widget.toolTip()); !tip.isEmpty()) return tip;
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget);
      line != nullptr && !line->placeholderText().isEmpty()) {
    return line->placeholderText();
  }
  return ownName(widget);
}

}  // namespace

void nameControls(QWidget* root) {
  const QList<QFormLayout*> forms = root->findChildren<QFormLayout*>();
  for (const QFormLayout* form : forms) {
    for (int row = 0; row < form->rowCount(); ++row) {
      const QString name = labelText(*form, row);
      QLayoutItem* item = form->itemAt(row, QFormLayout::FieldRole);
      if (!name.isEmpty() && item != nullptr && item->widget() != nullptr) nameRow(name, item->widget());
    }
  }
  const QList<QWidget*> widgets = root->findChildren<QWidget*>();
  for (QWidget* widget : widgets) {
    if (isControl(widget) && widget->accessibleName().isEmpty()) widget->setAccessibleName(fallbackName(*widget));
  }
}

}  // namespace boxprobe
