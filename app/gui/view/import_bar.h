// Asks over the picture how a model file is meant: its unit and its up axis. It waits beside the work, is never in the
// way of it, and goes when it is answered. Called by the model fitter; knows no document.
#pragma once

#include <QFrame>
#include <QString>

#include "filters/core/scene/scene.h"

class QComboBox;
class QLabel;

namespace boxprobe {

class ImportBar : public QFrame {
  Q_OBJECT

 public:
  /// Stands at the top of `picture`, hidden at first.
  explicit ImportBar(QWidget* picture);

  /// `why`: a sentence without its end; empty where the user asked for the bar.
  void ask(const QString& why, LengthUnit unit, UpAxis up);

 signals:
  void chosen(boxprobe::LengthUnit unit, boxprobe::UpAxis up);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QLabel* text_;
  QComboBox* unit_;
  QComboBox* up_;
};

/// "centimetres"
QString unitName(LengthUnit unit);
/// "Z up"
QString upAxisName(UpAxis up);

}  // namespace boxprobe
