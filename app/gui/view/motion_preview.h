// Cheaper techniques while something moves: says when the picture is in motion and when it has come to rest, as a
// setting that is kept. Called by the main window; draws nothing itself.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>

namespace boxprobe {

class MotionPreview : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<void(bool)> allow;      ///< whether programs for it are made ready
    std::function<bool(bool)> setMoving;  ///< true if a cheaper picture is shown then
  };

  /// Off until a setting is known: the one kept from last time, or by what draws.
  explicit MotionPreview(Hooks hooks, QObject* parent = nullptr);

  bool enabled() const { return enabled_; }
  /// By the user: kept for the next start.
  void setEnabled(bool enabled);
  /// Until the user has chosen: on where the processor draws, for there a picture can take longer than a hand moves.
  void setDefault(bool softwareRenderer);

  /// The camera or a handle moved. Tell it before the picture is drawn.
  void moved();
  /// Whatever moved was let go.
  void rest();
  /// A cheaper picture is shown until things come to rest.
  bool active() const { return active_; }

  /// How many milliseconds without a movement are rest. Tests lengthen it: a slow machine is no rest.
  void setRest(int milliseconds);
  /// Shorter, and a hand that slows down would see two pictures take turns.
  static constexpr int kRestMilliseconds = 200;

 signals:
  void enabledChanged(bool enabled);
  /// The full picture has to be drawn.
  void cameToRest();

 private:
  void apply(bool enabled);

  Hooks hooks_;
  QTimer resting_;
  bool enabled_ = false;
  bool active_ = false;
  std::optional<bool> chosen_;
};

}  // namespace boxprobe
