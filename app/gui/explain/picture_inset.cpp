// See picture_inset.h.
#include "app/gui/explain/picture_inset.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "app/gui/explain/schematic_painter.h"

namespace boxprobe {

namespace {

constexpr int kLetterPixels = 24;
constexpr double kMostWidth = 0.42, kMostHeight = 0.47;          ///< of the picture
constexpr double kLeastWidth = 160.0;                            ///< pixels, for a window that is narrow
constexpr double kPictureWidth = 560.0, kPictureHeight = 350.0;  ///< of a sheet's, for which the scale is
constexpr double kInsetScale = 1.4, kSmallestScale = 0.9, kLargestScale = 1.8;
constexpr double kCornerGap = 8.0;
constexpr double kPointSize = 10.0;

}  // namespace

void paintPictureLetter(QPainter& painter, const QPointF& middle, const char* text) {
  QFont font("DejaVu Serif");
  font.setPixelSize(kLetterPixels);
  font.setBold(true);
  font.setItalic(true);
  QPainterPath path;
  path.addText(0, 0, font, QString::fromUtf8(text));
  path.translate(middle - path.boundingRect().center());
  painter.strokePath(path, QPen(Qt::black, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, Qt::white);
}

void paintPictureInset(QPainter& painter, const QRectF& picture, const LessonInset& inset, const SchematicView& view) {
  const double share = std::min(picture.width() / kPictureWidth, picture.height() / kPictureHeight);
  const double scale = std::clamp(kInsetScale * share, kSmallestScale, kLargestScale);
  painter.save();
  QFont font("DejaVu Sans");
  font.setPointSizeF(kPointSize);
  painter.setFont(font);
  const QSizeF most(std::max(kMostWidth * picture.width(), kLeastWidth) / scale,
                    kMostHeight * picture.height() / scale);
  const QSizeF size = insetSize(painter, view, most);
  painter.translate(inset.right ? picture.right() - kCornerGap - scale * size.width() : picture.left() + kCornerGap,
                    inset.bottom ? picture.bottom() - kCornerGap - scale * size.height() : picture.top() + kCornerGap);
  painter.scale(scale, scale);
  paintInset(painter, QRectF(QPointF(), size), view,
             inset.elevation ? QCoreApplication::translate("PictureInset", "from the side")
                             : QCoreApplication::translate("PictureInset", "from above"));
  painter.restore();
}

void paintInsetPlace(QPainter& painter, const QPointF& place) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::black, 2.0));
  painter.setBrush(Qt::white);
  painter.drawEllipse(place, 5.0, 5.0);
  paintPictureLetter(painter, place + QPointF(-20.0, 8.0), "P");
}

PictureInset::PictureInset(QWidget* parent, std::function<Explanation(const QPointF&)> explain)
    : QWidget(parent), explain_(std::move(explain)) {
  setObjectName("lessonInset");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void PictureInset::show(const std::optional<LessonInset>& inset) {
  inset_ = inset;
  view_.reset();
  stale_ = true;
  hide();
}

void PictureInset::update(const QPointF& place) {
  if (!inset_ || (!std::exchange(stale_, false) && place == place_)) return;
  place_ = place;
  view_ = insetView(explain_(place), inset_->elevation);
  setGeometry(parentWidget()->rect());
  setVisible(view_.has_value());
  raise();
  QWidget::update();
}

void PictureInset::paintEvent(QPaintEvent*) {
  if (!view_ || !inset_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPictureInset(painter, QRectF(rect()), *inset_, *view_);
  paintInsetPlace(painter, place_);
}

}  // namespace boxprobe
