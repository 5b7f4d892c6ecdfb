// Clicks in the picture that take hold of nothing: they show the object under the pointer in the panels, or offer what
// can be done there. And the questions that the camera menu asks. Called by the main window.
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

class Editor;
class MenuBar;
class ProbeWidget;
class SceneSurfaces;
class ShownScene;
class ViewState;
class ViewCommands;
class Viewport;

class PictureMenu : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Editor& editor;
    ViewState& state;
    Viewport& viewport;
    ProbeWidget& handles;
    SceneSurfaces& surfaces;
    ViewCommands& views;
    ShownScene& shown;
    MenuBar& menu;
  };
  PictureMenu(const Parts& parts, QWidget* window);

  /// The object there is told by picked().
  void select(const QPointF& pixel);
  /// The probe that lights the surface there.
  void selectProbeOf(const QPointF& pixel);
  /// The probe that lights where the camera stands, else the nearest.
  void selectHere();
  /// What can be done at that pixel: of the probe whose handle is there, else of the selected one, and of the object.
  std::unique_ptr<QMenu> menuAt(const QPointF& pixel);
  void show(const QPointF& pixel);

  void storeCamera();
  void renameCamera(int index);

 signals:
  void picked(const QString& node, const QString& material);
  /// Asked for in the menu: their fields are to be brought into view.
  void shownInPanels(const QString& node, const QString& material);
  void message(const QString& text);

 private:
  void selectAt(const glm::dvec3& pointWorld, bool orNearest);
  void leaveOut(const std::string& node, bool out);

  Parts parts_;
  QWidget* window_;
};

}  // namespace boxprobe
