// See work_beside.h.
#include "app/gui/edit/work_beside.h"

#include <QCloseEvent>
#include <QEventLoop>
#include <QMetaObject>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "filters/core/base/scope_exit.h"

namespace boxprobe {

namespace {

int running = 0;  // the window's thread alone counts

/// Stays until the work has ended: whoever closes it asks for the end, if that can be asked for.
class WaitDialog : public QProgressDialog {
 public:
  using QProgressDialog::QProgressDialog;
  void reject() override { emit canceled(); }

 protected:
  void closeEvent(QCloseEvent* event) override {
    event->ignore();
    emit canceled();
  }
};

}  // namespace

bool workBesideRuns() {
  return running > 0;
}

void workBeside(QWidget* window, const QString& title, bool stoppable,
                const std::function<void(const BesideProgress&)>& work) {
  constexpr int kUnnoticedMilliseconds = 500, kRedrawMilliseconds = 50;
  ++running;
  const ScopeExit ended([] { --running; });
  QEventLoop loop;
  std::atomic<double> fraction{0.0};
  std::atomic<bool> cancelled{false}, done{false};
  std::exception_ptr thrown;
  std::thread thread([&] {
    try {
      work([&](double now) {
        fraction = now;
        return !cancelled;
      });
    } catch (...) {
      thrown = std::current_exception();
    }
    done = true;
    QMetaObject::invokeMethod(&loop, "quit", Qt::QueuedConnection);
  });
  // What is there at once needs no dialog; and nobody may edit what is about to be replaced.
  QTimer::singleShot(kUnnoticedMilliseconds, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  if (!done) {
    WaitDialog shown(title, QProgressDialog::tr("Cancel"), 0, 100, window);
    shown.setWindowModality(Qt::WindowModal);
    shown.setMinimumDuration(0);
    if (!stoppable) shown.setCancelButton(nullptr);
    shown.setAutoReset(false);
    // It hides itself then; what it waits for goes on for a while.
    QObject::connect(&shown, &QProgressDialog::canceled, &shown, [&] {
      cancelled = stoppable;
      if (stoppable) shown.setLabelText(QProgressDialog::tr("Cancelling"));
      for (auto* button : shown.findChildren<QPushButton*>()) button->setEnabled(false);
      shown.show();
    });
    QTimer redraw;
    QObject::connect(&redraw, &QTimer::timeout, &shown, [&shown, &fraction, &cancelled] {
      if (!cancelled) shown.setValue(std::min(static_cast<int>(100.0 * fraction), 99));
    });
    redraw.start(kRedrawMilliseconds);
    shown.show();
    if (!done) loop.exec();
  }
  cancelled = true;  // where the program ends, the loop does before the work
  thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace boxprobe
