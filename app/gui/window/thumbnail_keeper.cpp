// See thumbnail_keeper.h.
#include "app/gui/window/thumbnail_keeper.h"

#include <utility>

#include "app/gui/widgets/thumbnails.h"

namespace boxprobe {

ThumbnailKeeper::ThumbnailKeeper(Hooks hooks, QObject* parent) : QObject(parent), hooks_(std::move(hooks)) {
  constexpr int kMilliseconds = 700;
  later_.setInterval(kMilliseconds);
  connect(&later_, &QTimer::timeout, this, &ThumbnailKeeper::look);
}

void ThumbnailKeeper::opened() {
  due_ = hooks_.path();
  if (!due_.isEmpty()) later_.start();
}

void ThumbnailKeeper::look() {
  const QString path = hooks_.path();
  if (path.isEmpty()) return;  // a lesson's: until the own scene is back
  if (path == due_ && !hooks_.atRest()) return;
  later_.stop();
  if (path == due_) keepThumbnail(path, hooks_.picture());
}

}  // namespace boxprobe
