// See render_scheduler.h.
#include "app/gui/view/render_scheduler.h"

#include <algorithm>
#include <utility>

namespace boxprobe {

namespace {

/// While work goes on, pictures of its progress are at least this far apart, and so far that drawing them takes no more
/// than a fifth of the time: a picture can cost as much as several units of work.
constexpr qint64 kProgressPictureMilliseconds = 250;
constexpr qint64 kWorkTimesPicture = 4;

}  // namespace

RenderScheduler::RenderScheduler(Hooks hooks, QObject* parent) : QObject(parent), hooks_(std::move(hooks)) {
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &RenderScheduler::turn);
  sinceRender_.start();
}

void RenderScheduler::requestRender() {
  renderRequested_ = true;
  wake();
}

void RenderScheduler::sceneChanged() {
  stopped_ = false;
  requestRender();
}

void RenderScheduler::stopWork() {
  if (!working_) return;
  stopped_ = true;
  wake();
}

void RenderScheduler::resumeWork() {
  stopped_ = false;
  wake();
}

void RenderScheduler::wake() {
  if (!timer_.isActive()) timer_.start();
}

void RenderScheduler::turn() {
  if (!hooks_.ready()) return;
  ++turns_;

  if (!stopped_ && hooks_.workPending()) {
    working_ = true;
    hooks_.step();
    emit workProgressed(hooks_.progress());
  }
  const bool more = !stopped_ && hooks_.workPending();
  const bool ended = working_ && !more;
  if (ended) working_ = false;

  if (renderRequested_ || ended || (more && sinceRender_.elapsed() > progressInterval_)) {
    renderRequested_ = false;
    sinceRender_.restart();
    hooks_.render();
    progressInterval_ = std::max(kProgressPictureMilliseconds, kWorkTimesPicture * sinceRender_.elapsed());
    ++renders_;
    sinceRender_.restart();
    emit rendered();
    // Captures come first: what they change begins the picture again.
    if (!more && hooks_.refinable()) requestRender();
  }
  if (ended) emit workEnded();
  // A picture may find out what it lacks.
  if (more || (!stopped_ && hooks_.workPending())) wake();
}

}  // namespace boxprobe
