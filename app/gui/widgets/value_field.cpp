// See value_field.h.
#include "app/gui/widgets/value_field.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStatusTipEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <limits>

#include "app/gui/widgets/differs.h"
#include "app/gui/widgets/typed_number.h"

namespace boxprobe {

ValueField::ValueField(const Format& format, QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(format.decimals);
  setRange(format.minimum, format.maximum);
  setSingleStep(format.step);
  setSuffix(format.suffix);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);  // not by the wheel: scrolling the panel must not change values
  setAlignment(Qt::AlignRight);
  setAccelerated(true);
  restTimer_.setSingleShot(true);
  restTimer_.setInterval(kRestMilliseconds);
  connect(&restTimer_, &QTimer::timeout, this, &ValueField::commitPreview);
  connect(this, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &ValueField::changed);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { typed_ = true; });
  connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
    if (differs_ && typed_) emit committed(value());
    typed_ = false;
  });
}

QString ValueField::textFromValue(double value) const {
  return differs_ ? differsText() : shownNumber(value, decimals());
}

QString ValueField::withoutUnit(const QString& text) const {
  QString number = text.trimmed();
  const QString before = prefix().trimmed(), unit = suffix().trimmed();
  if (!before.isEmpty() && number.startsWith(before)) number.remove(0, before.size());
  if (!unit.isEmpty() && number.endsWith(unit)) number.chop(unit.size());
  return number.trimmed();
}

QValidator::State ValueField::validate(QString& text, int&) const {
  const QString number = withoutUnit(text);
  if (differs_ && number == differsText()) return QValidator::Intermediate;
  // Letters are not even typed; two separators are, to be refused with a line.
  for (const QChar c : number) {
    if (c.isLetter()) return QValidator::Invalid;
  }
  const TypedNumber typed = typedNumber(number);
  if (!typed.value) return QValidator::Intermediate;
  return *typed.value >= minimum() && *typed.value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

double ValueField::valueFromText(const QString& text) const {
  return typedNumber(withoutUnit(text)).value.value_or(value());
}

void ValueField::fixup(QString& text) const {
  const QString number = withoutUnit(text);
  if (number.isEmpty() || (differs_ && number == differsText())) return;
  const TypedNumber typed = typedNumber(number);
  const QString why =
      typed.value ? tr("%1 is not between %2 and %3")
                        .arg(number.trimmed(), shownNumber(minimum(), decimals()), shownNumber(maximum(), decimals()))
                  : typed.why;
  auto* self = const_cast<ValueField*>(this);  // Qt's own signature
  QToolTip::showText(mapToGlobal(QPoint(0, height())), why, self);
  QStatusTipEvent told(why);
  QApplication::sendEvent(self, &told);
  emit self->refused(why);
}

void ValueField::setDiffers(bool differs) {
  if (differs == differs_) return;
  differs_ = differs;
  if (hasFocus() && lineEdit()->isModified()) return;
  const QSignalBlocker quiet(this);
  setValue(QDoubleSpinBox::value());  // writes the text anew
}

void ValueField::show(double value) {
  if (hasFocus() && lineEdit()->isModified()) return;
  const QSignalBlocker quiet(this);
  if (QDoubleSpinBox::value() != value) setValue(value);
}

void ValueField::setBounds(double minimum, double maximum) {
  const QSignalBlocker quiet(this);
  setRange(std::min(minimum, value()), std::max(maximum, value()));
}

void ValueField::scrubTo(double value) {
  stepping_ = true;
  setValue(value);
  stepping_ = false;
  restTimer_.stop();
}

void ValueField::endScrub() {
  commitPreview();
}

void ValueField::setRest(int milliseconds) {
  restTimer_.setInterval(milliseconds);  // begins anew if it runs
}

void ValueField::stepBy(int steps) {
  stepping_ = true;
  QDoubleSpinBox::stepBy(steps);
  stepping_ = false;
}

void ValueField::changed(double value) {
  typed_ = false;
  if (stepping_) {
    previewing_ = true;
    emit previewed(value);
    restTimer_.start();
    return;
  }
  previewing_ = false;
  restTimer_.stop();
  emit committed(value);
}

void ValueField::commitPreview() {
  // An arrow held down repeats slower than the timer at first.
  if (QApplication::mouseButtons().testFlag(Qt::LeftButton) && hasFocus() && underMouse()) return restTimer_.start();
  restTimer_.stop();
  if (!previewing_) return;
  previewing_ = false;
  emit committed(value());
}

// Not the rest's timer with another interval: it would keep that.
void ValueField::commitSoon() {
  if (previewing_) QTimer::singleShot(0, this, &ValueField::commitPreview);
}

void ValueField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  QDoubleSpinBox::wheelEvent(event);
}

void ValueField::mouseReleaseEvent(QMouseEvent* event) {
  QDoubleSpinBox::mouseReleaseEvent(event);
  commitSoon();
}

void ValueField::focusOutEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusOutEvent(event);
  commitSoon();
}

bool ValueField::event(QEvent* event) {
  // Unless text is being typed, undo and redo are the document's and not the text's.
  if (event->type() == QEvent::ShortcutOverride && !lineEdit()->isModified()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return false;
    }
  }
  return QDoubleSpinBox::event(event);
}

}  // namespace boxprobe
