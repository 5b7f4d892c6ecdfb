// Turns the sky's picture by a drag in the view and by keys. Called by the view's tools; what it edits goes through the
// editor, a drag as one step.
#pragma once

#include <QObject>
#include <optional>

#include "app/gui/edit/editor.h"

namespace boxprobe {

class SkyTurn : public QObject {
  Q_OBJECT

 public:
  SkyTurn(Editor& editor, QObject* parent) : QObject(parent), editor_(editor) {}

  static constexpr double kStep = 5.0;  ///< degrees a key press

  /// One step of its own.
  void turnBy(double degrees);
  /// Degrees since the drag began.
  void drag(double degrees);
  void endDrag();

 signals:
  void message(const QString& text);

 private:
  bool hasPicture();

  Editor& editor_;
  std::optional<double> before_;  ///< the drag
  double turned_ = 0.0;
};

}  // namespace boxprobe
