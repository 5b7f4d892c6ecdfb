// Blend distance: one number for all six faces, and the six of them when unfolded. Called by the probe panel; knows no
// document.
#pragma once

#include <QWidget>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class ValueField;
class VectorRow;

class BlendRow : public QWidget {
  Q_OBJECT

 public:
  explicit BlendRow(QWidget* parent = nullptr);

  void show(const BlendDistance& blend);
  ValueField* all() const { return all_; }
  /// The unfolding part, as wide as the panel: the panel places it below this row.
  QWidget* faces() const { return faces_; }
  VectorRow* minFaces() const { return min_; }

 signals:
  void previewed(const BlendDistance& blend);
  void committed(const BlendDistance& blend);

 private:
  BlendDistance shown_;
  ValueField* all_;
  QWidget* faces_;
  VectorRow* min_;
  VectorRow* max_;
};

}  // namespace boxprobe
