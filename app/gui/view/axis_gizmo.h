// The world's axes in a corner of the picture: which way the view is turned, and a click looks along one of them.
// Called by the main window; knows a view, no scene.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "filters/core/geometry/probe_frame.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

class AxisGizmo : public QWidget {
  Q_OBJECT

 public:
  /// In the top right corner of `picture`.
  AxisGizmo(std::function<ViewProjection()> view, QWidget* picture);

  /// Where the knob of that axis is drawn, in the widget's pixels.
  QPointF knob(const BoxFace& face) const;

 signals:
  void chosen(const boxprobe::BoxFace& face);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::array<glm::dvec3, 6> directions() const;  ///< on the screen: right, up, towards the viewer
  std::optional<BoxFace> at(const QPointF& place) const;
  void place();

  std::function<ViewProjection()> view_;
  std::optional<BoxFace> hovered_;
};

}  // namespace boxprobe
