// What a frame does and leaves out: draws by their number of probes, programs, lookups, which object uses which probes
// with which weights, what each probe holds. Of the object selected here, which probes it may use. Called by the main
// window after each picture; while it cannot be seen it asks for nothing.
#pragma once

#include <QWidget>
#include <functional>

#include "app/cli/report/frame_costs.h"
#include "app/gui/edit/editor.h"
#include "filters/vtk/frame/frame_report.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace boxprobe {

class QuietCombo;
class Workspace;

class FramePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FramePanel(Workspace& workspace);

  void setWatched(bool watched);

 private:
  void update();
  QTreeWidgetItem* section(const QString& title);
  void fill(const FrameReport& report);
  void countLookups();
  void measureCosts();
  /// Draws many times, and says so meanwhile; no parts: stopped.
  FrameCosts costs();
  void selectionChanged();
  void showModes();
  void changeObject(const QString& label, const std::function<void(ObjectOverride&)>& change);

  Workspace& workspace_;
  Editor& editor_;
  bool watched_ = false;
  QLabel* summary_;
  QTreeWidget* tree_;
  QPushButton *count_, *heatMap_, *costs_;
  QWidget* objectPart_;
  QLabel* objectName_;
  QuietCombo *mode_, *weights_;
  std::string object_;  ///< node of the selected one
};

}  // namespace boxprobe
