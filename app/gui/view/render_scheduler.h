// When the window renders: however many things change in one turn of the event loop, at most one picture is drawn in
// it; between pictures, capture and filter work goes on one unit per turn, so that the window keeps answering. Called
// by whatever changes the picture; it knows a window and work only as functions.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>

namespace boxprobe {

class RenderScheduler : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> ready;   ///< false while there is no GL context to draw with: turns wait
    std::function<void()> render;  ///< one picture
    std::function<bool()> workPending;
    std::function<void()> step;        ///< one unit of work
    std::function<double()> progress;  ///< 0..1
    std::function<bool()> refinable;   ///< a further picture would be a better one
  };

  explicit RenderScheduler(Hooks hooks, QObject* parent = nullptr);

  /// A picture in the next turn. Any number of calls before then make one picture.
  void requestRender();
  /// The scene changed: a picture, and whatever work it caused; work that was stopped goes on.
  void sceneChanged();
  /// Leaves the remaining work until the scene changes again or resumeWork().
  void stopWork();
  void resumeWork();
  bool workStopped() const { return stopped_; }
  /// The window became able to draw.
  void wake();

  /// Nothing requested and nothing left to do, or nothing that would be done unasked.
  bool idle() const { return !timer_.isActive() && !renderRequested_; }
  std::uint64_t renders() const { return renders_; }
  std::uint64_t turns() const { return turns_; }

 signals:
  void rendered();
  void workProgressed(double fraction);
  void workEnded();  ///< done or stopped

 private:
  void turn();

  Hooks hooks_;
  QTimer timer_;
  QElapsedTimer sinceRender_;
  qint64 progressInterval_ = 0;  ///< milliseconds
  bool renderRequested_ = false;
  bool working_ = false;
  bool stopped_ = false;
  std::uint64_t renders_ = 0;
  std::uint64_t turns_ = 0;
};

}  // namespace boxprobe
