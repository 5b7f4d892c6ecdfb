// See background_work.h.
#include "app/gui/edit/background_work.h"

#include <QCoreApplication>
#include <QEvent>
#include <exception>
#include <utility>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

// Plain events and not queued calls of lambdas: Qt destroys those in whichever thread lets go of them last.
QEvent::Type progressedEvent() {
  static const int type = QEvent::registerEventType();
  return static_cast<QEvent::Type>(type);
}

QEvent::Type endedEvent() {
  static const int type = QEvent::registerEventType();
  return static_cast<QEvent::Type>(type);
}

}  // namespace

BackgroundWork::~BackgroundWork() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void BackgroundWork::start(Work work) {
  if (running_) return;
  if (thread_.joinable()) thread_.join();
  stop_ = false;
  percent_ = 0;
  thread_ = std::thread([this, work = std::move(work)] {
    Finish finish;
    QString error;
    try {
      finish = work([this](double fraction) {
        const int percent = static_cast<int>(100.0 * fraction);
        if (percent_.exchange(percent) != percent) {
          QCoreApplication::postEvent(this, new QEvent(progressedEvent()));
        }
        return !stop_;
      });
    } catch (const std::exception& caught) {
      error = QString::fromStdString(messageOf(caught));
    }
    {
      const std::lock_guard<std::mutex> lock(resultMutex_);
      finish_ = std::move(finish);
      error_ = std::move(error);
    }
    QCoreApplication::postEvent(this, new QEvent(endedEvent()));
  });
  running_ = true;  // not if no thread could be started; what the thread hands over comes later, from the event loop
}

bool BackgroundWork::event(QEvent* event) {
  if (event->type() == progressedEvent()) {
    emit progressed();
    return true;
  }
  if (event->type() == endedEvent()) {
    finishHere();
    return true;
  }
  return QObject::event(event);
}

void BackgroundWork::finishHere() {
  Finish finish;
  QString error;
  {
    const std::lock_guard<std::mutex> lock(resultMutex_);
    finish = std::exchange(finish_, {});
    error = std::exchange(error_, {});
  }
  running_ = false;
  if (finish) finish();
  emit ended(!finish && error.isEmpty(), error);
}

}  // namespace boxprobe
