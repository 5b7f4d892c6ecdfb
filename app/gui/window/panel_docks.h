// The docks of the window, the outliner at its left and the panels at its right: makes the panels and lays them out.
#pragma once

#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

#include "filters/core/scene/scene.h"

class QComboBox;
class QDockWidget;
class QMainWindow;
class QWidget;

namespace boxprobe {

class DebugView;
class FitPanel;
class Inspectors;
class MaterialPanel;
class ObjectPanel;
class Outliner;
class PlacePanel;
class ProbePreview;
class Workspace;

class PanelDocks : public QObject {
  Q_OBJECT

 public:
  PanelDocks(Workspace& workspace, DebugView& debugView, QMainWindow* window);
  /// Nothing is read from the graphics side any more.
  void stopReading();

 private:
  void add(QDockWidget* dock);
  QDockWidget* addTab(const QString& title, const char* name, QWidget* content);
  void buildOutliner();
  void buildInspectors();
  void buildPictures(DebugView& debugView);
  void showGhosts();
  void showHeadings();
  QStringList materialsOf(const QString& node) const;
  void show(const QString& node, const QString& material);

  Workspace& workspace_;
  QMainWindow* window_;
  Inspectors* inspectors_ = nullptr;
  QDockWidget* first_ = nullptr;  ///< the others are tabs beside it
  Outliner* outliner_ = nullptr;
  FitPanel* fitPanel_ = nullptr;
  std::optional<Probe> fitGhost_;
  std::vector<Probe> placeGhosts_;
  MaterialPanel* materialPanel_ = nullptr;
  ObjectPanel* objectPanel_ = nullptr;
  ProbePreview* preview_ = nullptr;
};

}  // namespace boxprobe
