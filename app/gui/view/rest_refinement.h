// A picture that rests goes on to the truth: says when the view has rested long enough for that and when it moves
// again, as a setting that is kept. Called by PictureWork; draws nothing itself.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

namespace boxprobe {

class RestRefinement : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> everRests;       ///< false: what is shown never does, or shows techniques as they are
    std::function<bool()> resting;         ///< nothing is dragged, captured or left to draw
    std::function<void(bool)> setRefined;  ///< from the next picture on
  };

  /// As it was kept from last time; on until the user has chosen.
  explicit RestRefinement(Hooks hooks, QObject* parent = nullptr);

  bool enabled() const { return enabled_; }
  /// By the user: kept for the next start.
  void setEnabled(bool enabled);
  /// Pictures are refined.
  bool active() const { return active_; }

  /// Anything that shows has changed. Tell it before the picture is drawn.
  void moved();

  /// How many milliseconds without a change are rest.
  void setRest(int milliseconds);
  static constexpr int kRestMilliseconds = 500;

 signals:
  void enabledChanged(bool enabled);
  /// Another picture has to be drawn: a better one, or the technique's own again.
  void switched();

 private:
  void rested();
  void stop();

  Hooks hooks_;
  QTimer resting_;
  bool enabled_;
  bool active_ = false;
};

}  // namespace boxprobe
