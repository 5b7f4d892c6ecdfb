// See cube_view.h.
#include "app/gui/widgets/cube_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>

#include "app/gui/widgets/pointer_place.h"

namespace boxprobe {

namespace {

constexpr int kWidth = 400;

}  // namespace

CubeFaces::CubeFaces(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

QSize CubeFaces::sizeHint() const {
  return {kWidth, heightForWidth(kWidth)};
}

int CubeFaces::heightForWidth(int width) const {
  return kind_ == CubePictureKind::Cross ? 3 * width / 4 : width / 2;
}

void CubeFaces::show(const CubeMap* cube, CubePictureKind kind, float exposure, const QString& instead) {
  if (kind != kind_) updateGeometry();
  kind_ = kind;
  instead_ = instead;
  image_ = {};
  if (cube != nullptr && !cube->empty()) {
    const ImageRgba8 picture = drawCubePicture(*cube, 0, CubePicture(kind, width()), exposure);
    image_ = QImage(picture.pixels.data(), picture.width, picture.height, QImage::Format_RGBA8888).copy();
  }
  update();
}

void CubeFaces::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image_.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, instead_);
  } else {
    painter.drawImage(0, 0, image_);
  }
}

void CubeFaces::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = pointerPlace(*event);
  emit pointed(image_.isNull() ? std::nullopt : CubePicture(kind_, image_.width()).direction({at.x(), at.y()}));
}

void CubeFaces::leaveEvent(QEvent*) {
  emit pointed(std::nullopt);
}

void CubeFaces::resizeEvent(QResizeEvent* event) {
  if (event->size().width() != event->oldSize().width()) emit widthChanged();
}

}  // namespace boxprobe
