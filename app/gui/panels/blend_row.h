// Blend distance: one number for all six faces, and the six of them when unfolded. Called by the probe panel; knows no
// document.
#pragma once

#include <QWidget>
#include <array>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class ValueField;
class VectorRow;

/// With one distance replaced; `face` as BlendRow tells it.
BlendDistance withBlend(BlendDistance blend, int face, double distance);

class BlendRow : public QWidget {
  Q_OBJECT

 public:
  explicit BlendRow(QWidget* parent = nullptr);

  void show(const BlendDistance& blend);
  /// Faces, in the order of BoxFace::index(), in which the selected probes do not agree.
  void showDiffers(const std::array<bool, 6>& faces);
  ValueField* all() const { return all_; }
  /// The unfolding part, as wide as the panel: the panel places it below this row.
  QWidget* faces() const { return faces_; }
  VectorRow* minFaces() const { return min_; }

 signals:
  /// `face` is a BoxFace::index(), or -1 for all six.
  void previewed(int face, double distance);
  void committed(int face, double distance);

 private:
  ValueField* all_;
  QWidget* faces_;
  VectorRow* min_;
  VectorRow* max_;
};

}  // namespace boxprobe
