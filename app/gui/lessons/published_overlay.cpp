// See published_overlay.h.
#include "app/gui/lessons/published_overlay.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/lessons/published_picture.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr double kPixels = 64000.0;     ///< of the picture: a second or two of work
constexpr int kRowsATurn = 12;          ///< some ten milliseconds, between which the window answers
constexpr int kRestMilliseconds = 300;  ///< without a change, before it is drawn again

}  // namespace

PublishedOverlay::PublishedOverlay(Workspace& workspace)
    : renderer_(workspace.renderer()),
      viewport_(workspace.viewport()),
      document_(workspace.document()),
      picture_(new QLabel(&viewport_)),
      note_(new QLabel(&viewport_)) {
  picture_->setObjectName("publishedPicture");
  picture_->setScaledContents(true);
  note_->setStyleSheet(
      "QLabel { color: #f4f4f4; background: rgba(16, 18, 22, 210); border-radius: 5px; padding: 6px 10px; }");
  note_->setWordWrap(true);
  for (QLabel* label : {picture_, note_}) {
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->hide();
  }
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &PublishedOverlay::turn);
}

PublishedOverlay::~PublishedOverlay() = default;

void PublishedOverlay::show(const std::string& form) {
  form_ = form;
  invalidate();
}

void PublishedOverlay::invalidate() {
  drawing_.reset();
  complete_ = false;
  picture_->hide();
  note_->hide();
  timer_.stop();
  if (!form_.empty()) timer_.start(kRestMilliseconds);
}

void PublishedOverlay::place() {
  note_->setFixedWidth(std::min(viewport_.width() - 24, 460));
  note_->adjustSize();
  note_->move(12, 12);
  note_->show();
  note_->raise();
}

void PublishedOverlay::turn() {
  // The end of the captures invalidates again.
  if (!viewport_.readyToDraw() || document_.previewing()) return;
  try {
    viewport_.window3d()->MakeCurrent();
    // What is looked at here may begin a lattice of its own, of which no frame knows.
    if (renderer_.workPending()) {
      renderer_.step();
      return timer_.start(0);
    }
    if (!drawing_) {
      const double aspect = static_cast<double>(viewport_.width()) / std::max(viewport_.height(), 1);
      const int width = std::max(static_cast<int>(std::lround(std::sqrt(kPixels * aspect))), 1);
      scene_ = document_.scene();
      drawing_ = std::make_unique<PublishedPicture>(renderer_, scene_, form_, width,
                                                    std::max(static_cast<int>(std::lround(width / aspect)), 1));
    }
    if (drawing_->draw(kRowsATurn)) {
      note_->setText(tr("Drawing the picture with the published formula..."));
      place();
      timer_.start(0);
      return;
    }
    const ImageRgba8 image = drawing_->display(1);
    const QImage shown(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
    picture_->setPixmap(QPixmap::fromImage(shown));
    picture_->setGeometry(viewport_.rect());
    picture_->show();
    picture_->raise();
    note_->setText(
        tr("The picture with the published formula, drawn on the CPU. It is drawn again when you move the view."));
    place();
  } catch (const std::exception& error) {
    note_->setText(QString::fromStdString(messageOf(error)));
    place();
  }
  drawing_.reset();
  complete_ = true;
}

}  // namespace boxprobe
