// The picture in the window: a GL widget that hands the mouse to the probes' handles first and to the camera after.
// Called by the main window, which renders into its vtkGenericOpenGLRenderWindow; knows no document.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>

#include <functional>
#include <optional>

#include "app/gui/view/camera_controller.h"
#include "filters/vtk/widgets/view_projection.h"

class QLabel;
class vtkCamera;
class vtkGenericOpenGLRenderWindow;

namespace boxprobe {

class ProbeWidget;

class Viewport : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;
  /// Wider than the least, which is for small windows alone.
  QSize sizeHint() const override { return {320, 240}; }

  vtkGenericOpenGLRenderWindow* window3d() const;
  /// `meet`: where a ray meets a surface; `bounds`: of the scene.
  void setCamera(std::function<vtkCamera*()> camera, std::function<std::optional<glm::dvec3>(const Ray&)> meet,
                 std::function<Box()> bounds);
  CameraController& cameraController() { return cameraController_; }
  void setProbeWidget(ProbeWidget* widget);
  /// The view as it is now, in logical pixels.
  ViewProjection view() const;
  /// A GL context exists and the widget is on a screen.
  bool readyToDraw() const;
  /// Emits contextLost if the context is gone, once.
  void noticeLostContext();
  /// The processor draws, not a graphics card. Known once there is a context.
  bool softwareRenderer() const { return softwareRenderer_; }
  /// Numbers beside the pointer; an empty text hides them.
  void showReadout(const QString& text, const QPointF& atPixel);
  /// While on, a click without a drag is told by `clicked`, and the camera waits until a drag is one.
  void setPicking(bool on);

 signals:
  void cameraMoved();
  /// As of CameraController: Ctrl, Shift and the left button dragged.
  void skyTurned(double degrees);
  void skyTurnEnded();
  void becameReady();
  /// The graphics driver was reset, or dropped the context; nothing is drawn from then on.
  void contextLost();
  /// Over the picture, no button held; logical pixels.
  void pointerMoved(const QPointF& position);
  void pointerLeft();
  /// On no handle. Only while picking is on.
  void clicked(const QPointF& position);
  /// On no handle, without a drag; only while picking is off.
  void selected(const QPointF& position);
  /// The second of two clicks on no handle; only while picking is off.
  void doubleClicked(const QPointF& position);
  /// A click with the right button.
  void menuRequested(const QPointF& position);

 protected:
  bool event(QEvent* event) override;
  void initializeGL() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void clickEnded(Qt::MouseButton button, const QPointF& at);

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  CameraController cameraController_;
  std::function<vtkCamera*()> camera_;
  ProbeWidget* probeWidget_ = nullptr;
  bool picking_ = false;
  bool softwareRenderer_ = false;
  bool lost_ = false;               ///< the context
  std::optional<QPointF> pressed_;  ///< while what began there may still become a click
  QLabel* readout_;
};

}  // namespace boxprobe
