// The docks of the window, the outliner at its left and the panels at its right: makes the panels of the scene, lays
// them out, and says which kinds of change each of them shows. Called by the main window; what the panels do is theirs.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/cli/report/frame_costs.h"
#include "app/gui/edit/change_views.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

class QDockWidget;
class QMainWindow;
class QWidget;

namespace boxprobe {

class BakePanel;
class CapturePanel;
class CostPanel;
class DebugView;
class Editor;
class FitPanel;
class FramePanel;
class Inspectors;
class LightPanel;
class MaterialPanel;
class MenuBar;
class ObjectPanel;
class Outliner;
class PicturePanel;
class PlacePanel;
class ProbeCommands;
class ProbePanel;
class ProbePreview;
class RenderScheduler;
class SceneRenderer;
class ViewState;
class Viewport;

class PanelDocks : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Editor& editor;
    ViewState& state;
    SceneRenderer& renderer;
    Viewport& viewport;
    RenderScheduler& scheduler;
    DebugView& debugView;
    MenuBar& menu;  ///< gets a switch for each dock
  };

  PanelDocks(QMainWindow* window, const Parts& parts);

  /// Each panel is updated for the kinds of change that it shows, and for no other.
  void subscribe(ChangeViews& views);
  /// Other geometry, in the order of scene.models.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  /// Their fields show the object and the material of these names, without the latter the object's own; nothing is
  /// raised, turned or scrolled.
  void show(const QString& node, const QString& material);
  /// The same, and they are brought into view.
  void reveal(const QString& node, const QString& material);
  /// Nothing is read from the graphics side any more.
  void stopReading();

  Outliner& outliner() { return *outliner_; }
  ProbeCommands& probeCommands() { return *commands_; }
  LightPanel& lightPanel() { return *lightPanel_; }
  BakePanel& bakePanel() { return *bakePanel_; }
  FitPanel& fitPanel() { return *fitPanel_; }
  PlacePanel& placePanel() { return *placePanel_; }

 signals:
  void pictureChanged();
  void message(const QString& text);
  void failed(const QString& line);
  /// All that fit and place propose now.
  void ghostsChanged(const std::vector<boxprobe::Probe>& ghosts);

 private:
  QDockWidget* add(const QString& title, const char* name, QWidget* content);
  void buildOutliner();
  void buildProbes();
  void buildPreview();
  void buildDebug();
  void buildCost();
  void buildFrame();
  FrameCosts measureCosts();
  void showGhosts();
  void showSelection();
  void showHeadings();
  QStringList materialsOf(const QString& node) const;

  QMainWindow* window_;
  std::vector<std::shared_ptr<const Model>> models_;
  Parts parts_;
  Inspectors* inspectors_ = nullptr;
  QDockWidget* first_ = nullptr;  ///< the others are tabs beside it
  Outliner* outliner_ = nullptr;
  ProbeCommands* commands_ = nullptr;
  ProbePanel* probePanel_ = nullptr;
  BakePanel* bakePanel_ = nullptr;
  FitPanel* fitPanel_ = nullptr;
  PlacePanel* placePanel_ = nullptr;
  std::optional<Probe> fitGhost_;
  std::vector<Probe> placeGhosts_;
  CapturePanel* capturePanel_ = nullptr;
  MaterialPanel* materialPanel_ = nullptr;
  ObjectPanel* objectPanel_ = nullptr;
  LightPanel* lightPanel_ = nullptr;
  PicturePanel* picturePanel_ = nullptr;
  ProbePreview* preview_ = nullptr;
  CostPanel* costPanel_ = nullptr;
  FramePanel* framePanel_ = nullptr;
};

}  // namespace boxprobe
