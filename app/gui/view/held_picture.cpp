// See held_picture.h.
#include "app/gui/view/held_picture.h"

#include <QEvent>
#include <QLabel>
#include <QPixmap>

#include "app/gui/view/viewport.h"

namespace boxprobe {

HeldPicture::HeldPicture(Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport), picture_(new QLabel(&viewport)), note_(new QLabel(picture_)) {
  picture_->setObjectName("heldPicture");
  picture_->setAttribute(Qt::WA_TransparentForMouseEvents);
  picture_->setScaledContents(true);
  picture_->hide();
  note_->setText(tr("Preparing the picture..."));
  note_->setStyleSheet("color: #f4f4f4; background: rgba(16, 18, 22, 210); border-radius: 5px; padding: 6px 10px;");
  viewport.installEventFilter(this);
}

bool HeldPicture::held() const {
  return picture_->isVisibleTo(&viewport_);
}

void HeldPicture::hold() {
  if (!viewport_.readyToDraw() || held()) return;
  const QImage shown = viewport_.grabFramebuffer();
  if (shown.isNull()) return;
  picture_->setPixmap(QPixmap::fromImage(shown));
  picture_->setGeometry(viewport_.rect());
  note_->adjustSize();
  note_->move(12, 12);
  picture_->raise();
  picture_->show();
}

void HeldPicture::release() {
  picture_->hide();
  picture_->clear();
}

bool HeldPicture::eventFilter(QObject*, QEvent* event) {
  // Whoever takes hold of the picture wants the one that is there, finished or not; a held one does not fit another
  // shape of the window.
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel || event->type() == QEvent::Resize) {
    if (held()) release();
  }
  return false;
}

}  // namespace boxprobe
