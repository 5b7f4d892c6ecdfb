// SIGTERM, SIGINT and SIGHUP end the window: unsaved changes go into a recovery file, nothing is asked. While a long
// step keeps the event loop from it, the handler writes what was unsaved half a second before. Used by runWindow.
#pragma once

#include <QObject>
#include <memory>

#include "app/session/interrupt.h"
#include "filters/core/scene/scene.h"
#include "filters/platform/wake_pipe.h"

class QSocketNotifier;
class QTimer;

namespace boxprobe {

class MainWindow;

class WindowSignals : public QObject {
 public:
  explicit WindowSignals(MainWindow& window);
  ~WindowSignals() override;

  /// 128 and the signal that ended the window, else 0.
  int exitStatus() const;

 private:
  void end();
  void keepUnsaved();

  MainWindow& window_;
  WakePipe pipe_;
  std::unique_ptr<InterruptGuard> guard_;
  std::unique_ptr<QSocketNotifier> notifier_;
  std::unique_ptr<QTimer> timer_;
  Scene kept_;  ///< what the handler would write
};

}  // namespace boxprobe
