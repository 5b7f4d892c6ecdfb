// See background_work.h.
#include "app/gui/edit/background_work.h"

#include <QMetaObject>
#include <exception>
#include <utility>

namespace boxprobe {

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
          QMetaObject::invokeMethod(this, &BackgroundWork::progressed, Qt::QueuedConnection);
        }
        return !stop_;
      });
    } catch (const std::exception& caught) {
      error = QString::fromUtf8(caught.what());
    }
    QMetaObject::invokeMethod(
        this,
        [this, finish, error] {
          running_ = false;
          if (finish) finish();
          emit ended(!finish && error.isEmpty(), error);
        },
        Qt::QueuedConnection);
  });
  running_ = true;  // not if no thread could be started; what the thread hands over comes later, from the event loop
}

}  // namespace boxprobe
