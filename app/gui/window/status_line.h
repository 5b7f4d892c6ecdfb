// The line under the picture: messages, what ran (counters) and the progress of capture with a button to stop it.
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "app/session/time_left.h"
#include "filters/core/base/counters.h"
#include "filters/vtk/frame/frame_count.h"
#include "filters/vtk/probes/bake_state.h"

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace boxprobe {

class Workspace;

class StatusLine : public QObject {
  Q_OBJECT

 public:
  StatusLine(Workspace& workspace, QStatusBar* bar);

 private:
  void showCounters(const Counters& counters);
  /// Off at first: they are for those who look into the program's work.
  void setCountersShown(bool shown);
  void showProgress(double fraction, const WorkNow& now);
  void hideProgress(bool stopped);
  /// Of the picture on the screen: how many frames it is the mean of, or that it stands in for a better one.
  void showPicture(const FrameCount& frames, bool preview);
  void showMessage(const QString& text);
  void showError(const QString& text);
  static QString workText(const WorkNow& now);
  void setFailed(bool failed);

  QStatusBar* bar_;
  QLabel* picture_;
  QLabel* counters_;
  QProgressBar* progress_;
  QToolButton* stop_;
  QToolButton* resume_;
  QElapsedTimer clock_;
  TimeLeft timeLeft_;
};

}  // namespace boxprobe
