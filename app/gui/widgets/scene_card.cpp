// See scene_card.h.
#include "app/gui/widgets/scene_card.h"

#include <QPainter>
#include <QPainterPath>

#include "app/gui/widgets/thumbnails.h"
#include "app/gui/widgets/tool_icons.h"
#include "app/gui/widgets/window_style.h"

namespace boxprobe {

namespace {

constexpr int kMargin = 6, kBelow = 4;  ///< about the picture; between it and the letters

}  // namespace

SceneCard::SceneCard(const QString& title, const QString& words, QWidget* parent)
    : QPushButton(parent), title_(title), words_(words) {
  setAttribute(Qt::WA_Hover);
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(words.isEmpty() ? title : tr("%1, %2").arg(title, words));
}

void SceneCard::setPicture(const QImage& picture) {
  picture_ = picture;
  update();
}

QSize SceneCard::sizeHint() const {
  return {kThumbnailSize.width() + 2 * kMargin,
          kThumbnailSize.height() + 2 * kMargin + kBelow + 2 * fontMetrics().lineSpacing()};
}

void SceneCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  constexpr double kRound = 5.0;
  const bool marked = underMouse() || hasFocus();
  if (marked || isDown()) {
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 1.5) : QPen(Qt::NoPen));
    painter.setBrush(palette().color(isDown() ? QPalette::Base : QPalette::Button));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75), kRound, kRound);
  }
  const QRect place(QPoint(kMargin, kMargin), kThumbnailSize);
  QPainterPath shape;
  shape.addRoundedRect(place, kRound - 1.0, kRound - 1.0);
  if (picture_.isNull()) {
    constexpr int kIcon = 40;
    painter.fillPath(shape, palette().color(QPalette::Base));
    const QRect middle(place.center() - QPoint(kIcon / 2, kIcon / 2), QSize(kIcon, kIcon));
    toolIcon(ToolIcon::Box).paint(&painter, middle);
  } else {
    painter.save();
    painter.setClipPath(shape);
    const QSizeF whole = QSizeF(picture_.size()).scaled(place.size(), Qt::KeepAspectRatioByExpanding);
    QRectF target(QPointF(), whole);
    target.moveCenter(QRectF(place).center());
    painter.drawImage(target, picture_);
    painter.restore();
  }
  const auto line = [&](int row, const QString& text, const QColor& color, Qt::TextElideMode elide) {
    const QRect at(kMargin, place.bottom() + 1 + kBelow + row * fontMetrics().lineSpacing(), place.width(),
                   fontMetrics().lineSpacing());
    painter.setPen(color);
    painter.drawText(at, Qt::AlignLeft | Qt::AlignVCenter, fontMetrics().elidedText(text, elide, at.width()));
  };
  line(0, title_, palette().color(QPalette::WindowText), Qt::ElideMiddle);
  line(1, words_, styleColor(StyleColor::Dim), Qt::ElideMiddle);
}

}  // namespace boxprobe
