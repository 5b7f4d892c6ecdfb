// What is done with the picture beside editing probes: views and cameras, clicks and the menu under the pointer, the
// clipboard, comparison, the list of keys; put together and connected to the menus. Called by the main window.
#pragma once

#include <QImage>
#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/view/picture_compare.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/window/picture_menu.h"

class QLabel;
class QMainWindow;
class vtkReflectionProbeRepresentation;

namespace boxprobe {

class ChangeViews;
class DebugView;
class ExposureTools;
class FaceTags;
class PanelDocks;
class RenderScheduler;
class SceneRenderer;
class ShownScene;
class StatusLine;
class ViewComparison;

class ViewTools : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Document& document;
    Editor& editor;
    ViewState& state;
    SceneRenderer& renderer;
    Viewport& viewport;
    vtkReflectionProbeRepresentation& shownHandles;
    ProbeWidget& handles;
    SceneSurfaces& surfaces;
    MenuBar& menu;
    PanelDocks& panels;
    DebugView& debugView;
    StatusLine& status;
    RenderScheduler& scheduler;
    std::function<std::vector<std::shared_ptr<const Model>>()> models;
  };
  ViewTools(const Parts& parts, QMainWindow* window);

  ViewCommands& views() { return *views_; }
  PictureMenu& pictureMenu() { return *pictureMenu_; }
  PictureCompare& compare() { return *compare_; }
  ViewComparison& sideBySide() { return *sideBySide_; }
  ShownScene& shownScene() { return *shown_; }
  /// Ends whichever comparison is under way; false without one.
  bool stopComparing();
  /// The renderer draws the document's scene when this returns, whatever views were being made.
  void showOwnScene();
  /// Once, with all that tells of changes.
  void subscribe(ChangeViews& views);
  /// Other models are shown: what was remembered of those before is forgotten.
  void modelsReplaced();

 signals:
  void automaticExposureWanted();

 private:
  void connectViews();
  void connectClicks(QMainWindow* window);
  void connectCompare();
  void connectSideBySide();
  void connectGauge();
  void connectShown();
  void connectOutliner();
  void showSceneWhole();
  void showKeys(bool shown);
  QImage barePicture();
  ImageRgbaF bareLight(const QSize& size);
  ProbesDiffuse shownDiffuse() const;

  Parts parts_;
  ViewCommands* views_;
  ShownScene* shown_;
  PictureMenu* pictureMenu_;
  CompareWipe* wipe_;
  PictureCompare* compare_;
  ViewComparison* sideBySide_;
  FaceTags* tags_;
  ExposureTools* exposure_;
  QLabel* keys_ = nullptr;
};

}  // namespace boxprobe
