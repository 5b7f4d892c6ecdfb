// See compare_wipe.h.
#include "app/gui/view/compare_wipe.h"

#include <QEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "app/gui/view/picture_difference.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/session/display_picture.h"

namespace boxprobe {

namespace {

constexpr int kBarWidth = 14;  ///< logical pixels: wide enough to be taken hold of

QLabel* caption(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  label->setStyleSheet(
      "QLabel { color: #f4f4f4; background: rgba(16, 18, 22, 210); border-radius: 4px; padding: 3px 8px; }");
  return label;
}

}  // namespace

CompareWipe::CompareWipe(QWidget* picture)
    : QWidget(picture),
      bar_(new QWidget(picture)),
      left_(caption(this, "compareLeft")),
      right_(caption(this, "compareRight")),
      numbers_(caption(this, "compareNumbers")) {
  setObjectName("compare");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  bar_->setObjectName("compareDivider");
  bar_->setCursor(Qt::SplitHCursor);
  bar_->setToolTip(tr("Drag: how much of each picture is shown"));
  left_->setText(tr("As it is now"));
  picture->installEventFilter(this);
  bar_->installEventFilter(this);
  setShown(false);
}

void CompareWipe::show(const QImage& other, const QString& name) {
  other_ = other;
  right_->setText(name);
  setShown(true);
}

void CompareWipe::showNumbers(const QString& text) {
  numbers_->setText(text);
  place();
}

void CompareWipe::setFlipped(bool flipped) {
  flipped_ = flipped;
  place();
}

void CompareWipe::setScaleShown(bool shown) {
  scale_ = shown;
  update();
}

void CompareWipe::setDivider(double share) {
  divider_ = std::clamp(share, 0.0, 1.0);
  place();
}

void CompareWipe::setShown(bool shown) {
  setVisible(shown);
  bar_->setVisible(shown && !flipped_);
  if (!shown) return;
  place();
  raise();
  bar_->raise();
}

void CompareWipe::place() {
  const QSize room = parentWidget()->size();
  setGeometry(QRect(QPoint(0, 0), room));
  const int at = static_cast<int>(divider_ * room.width());
  bar_->setGeometry(at - kBarWidth / 2, 0, kBarWidth, room.height());
  bar_->setVisible(isVisibleTo(parentWidget()) && !flipped_);
  for (QLabel* label : {left_, right_, numbers_}) label->adjustSize();
  constexpr int kMargin = 8;
  const int line = room.height() - kMargin - right_->height();
  left_->setVisible(!flipped_);
  left_->move(std::max(at - kMargin - left_->width(), kMargin), line);
  right_->move(flipped_ ? kMargin : std::min(at + kMargin, room.width() - kMargin - right_->width()), line);
  numbers_->setVisible(!numbers_->text().isEmpty());
  numbers_->move((room.width() - numbers_->width()) / 2, line - kMargin - numbers_->height());
  update();
}

void CompareWipe::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int at = flipped_ ? 0 : static_cast<int>(divider_ * width());
  painter.setClipRect(at, 0, width() - at, height());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), other_);
  if (scale_) paintScale(painter);
  if (flipped_) return;
  painter.setClipping(false);
  painter.setPen(QPen(haloColor(), 3.0));
  painter.drawLine(at, 0, at, height());
  painter.setPen(QPen(Qt::white, 1.0));
  painter.drawLine(at, 0, at, height());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(haloColor(), 1.0));
  painter.setBrush(Qt::white);
  painter.drawEllipse(QPointF(at, 0.5 * height()), 6.0, 6.0);
}

void CompareWipe::paintScale(QPainter& painter) const {
  constexpr int kWidth = 14, kHeight = 160, kMargin = 12, kText = 46;
  const QRect bar(width() - kMargin - kWidth, (height() - kHeight) / 2, kWidth, kHeight);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(16, 18, 22, 210));
  painter.drawRoundedRect(bar.adjusted(-kText - 4, -10, 6, 10), 4.0, 4.0);
  for (int y = 0; y < kHeight; ++y) {
    painter.fillRect(bar.left(), bar.top() + y, kWidth, 1,
                     differenceColor(kMostDifference * (1.0 - y / (kHeight - 1.0))));
  }
  painter.setPen(QColor(244, 244, 244));
  constexpr int kSteps = 5;
  for (int i = 0; i <= kSteps; ++i) {
    const int y = bar.bottom() - i * (kHeight - 1) / kSteps;
    const QString percent = QString("%1 %").arg(100.0 * kMostDifference * i / kSteps, 0, 'f', 0);
    painter.drawText(QRect(bar.left() - kText, y - 10, kText - 6, 20), Qt::AlignRight | Qt::AlignVCenter, percent);
  }
}

bool CompareWipe::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisibleTo(parentWidget())) place();
  if (watched == bar_ && event->type() == QEvent::MouseMove) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->buttons().testFlag(Qt::LeftButton) && width() > 0) {
      setDivider(static_cast<double>(bar_->mapToParent(mouse->pos()).x()) / width());
    }
    return true;
  }
  // What begins on the divider is no click on the picture.
  return watched == bar_ && (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease);
}

}  // namespace boxprobe
