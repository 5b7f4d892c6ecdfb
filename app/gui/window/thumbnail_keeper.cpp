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
  looks_ = 0;
  if (!due_.isEmpty()) later_.start();
}

void ThumbnailKeeper::look() {
  const QString path = hooks_.path();
  if (path.isEmpty()) return;     // a lesson's: until the own scene is back
  constexpr int kMostLooks = 90;  // about a minute
  const bool rests = hooks_.atRest();
  if (path == due_ && !rests && ++looks_ < kMostLooks) return;
  later_.stop();
  if (path == due_ && rests) keepThumbnail(path, hooks_.picture());
}

}  // namespace boxprobe
