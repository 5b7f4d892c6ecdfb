// The world's axes in a corner of the picture: which way the view is turned, and a click looks along one of them.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "filters/core/geometry/probe_frame.h"
#include "filters/vtk/widgets/view_projection.h"

namespace boxprobe {

class Workspace;

class AxisGizmo : public QWidget {
  Q_OBJECT

 public:
  /// In the picture's top right corner.
  explicit AxisGizmo(Workspace& workspace);

  /// Where the knob of that axis is drawn, in the widget's pixels.
  QPointF knob(const BoxFace& face) const;

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

  Workspace& workspace_;
  std::optional<BoxFace> hovered_;
};

}  // namespace boxprobe
