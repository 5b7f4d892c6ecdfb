// Clicks in the picture that take hold of nothing: they show the object under the pointer in the panels, or offer what
// can be done there.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

class QMenu;
class QWidget;

namespace boxprobe {

class Workspace;

class PictureMenu : public QObject {
  Q_OBJECT

 public:
  PictureMenu(Workspace& workspace, QWidget* window);

  /// What can be done at that pixel: of the probe whose handle is there, else of the selected one, and of the object.
  std::unique_ptr<QMenu> menuAt(const QPointF& pixel);

 private:
  void show(const QPointF& pixel);
  /// The object there.
  void select(const QPointF& pixel);
  /// The probe that lights the surface there.
  void selectProbeOf(const QPointF& pixel);
  /// The probe that lights where the camera stands, else the nearest.
  void selectHere();
  void selectAt(const glm::dvec3& pointWorld, bool orNearest);
  void leaveOut(const std::string& node, bool out);

  Workspace& workspace_;
  QWidget* window_;
};

}  // namespace boxprobe
