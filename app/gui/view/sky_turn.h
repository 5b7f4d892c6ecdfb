// Turns the sky's picture by a drag in the view, which is one step, and by keys.
#pragma once

#include <QObject>
#include <optional>

namespace boxprobe {

class Workspace;

class SkyTurn : public QObject {
  Q_OBJECT

 public:
  SkyTurn(Workspace& workspace, QObject* parent);

 private:
  /// One step of its own.
  void turnBy(double degrees);
  /// Degrees since the drag began.
  void drag(double degrees);
  void endDrag();
  bool hasPicture();

  Workspace& workspace_;
  std::optional<double> before_;  ///< the drag
  double turned_ = 0.0;
};

}  // namespace boxprobe
