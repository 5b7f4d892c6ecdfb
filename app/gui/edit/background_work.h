// Long work in a thread of its own, whose result is used in the window's thread: progress, stop, errors. Called by the
// panels that fit and place.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace boxprobe {

class BackgroundWork : public QObject {
  Q_OBJECT

 public:
  /// Told how far the work is, 0 to 1; false: stop.
  using Progress = std::function<bool(double)>;
  /// What to do with a result, in the window's thread.
  using Finish = std::function<void()>;
  /// Runs in the thread; must not touch the window. An empty Finish: it was stopped.
  using Work = std::function<Finish(const Progress&)>;

  explicit BackgroundWork(QObject* parent = nullptr) : QObject(parent) {}
  /// Stops the work under way and waits for it.
  ~BackgroundWork() override;

  /// One at a time: nothing while it is running.
  void start(Work work);
  /// Asks it to stop; ended() follows.
  void stop() { stop_ = true; }
  bool running() const { return running_; }
  int percent() const { return percent_; }

 signals:
  void progressed();
  /// After the Finish, if there was one. `error`: what was thrown.
  void ended(bool stopped, const QString& error);

 protected:
  bool event(QEvent* event) override;

 private:
  void finishHere();

  std::thread thread_;
  std::mutex resultMutex_;
  Finish finish_;  ///< left by the thread, with its error; taken and destroyed in the window's thread
  QString error_;
  std::atomic<bool> stop_{false};
  std::atomic<int> percent_{0};
  bool running_ = false;
};

}  // namespace boxprobe
