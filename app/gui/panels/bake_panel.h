// Baking from the window: how far the selected probe's maps are, buttons to make them again, to stop, and to keep them
// as files.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/panels/bake_state_look.h"

class QLabel;
class QToolButton;

namespace boxprobe {

class RenderScheduler;
class Workspace;

class BakePanel : public QWidget {
  Q_OBJECT

 public:
  explicit BakePanel(Workspace& workspace);

  void bakeSelected();
  void bakeAll();
  /// Asks for a folder and writes every baked probe, one a turn of the event loop.
  void saveBaked();

 signals:
  /// One a probe, in the scene's order.
  void statesChanged(const std::vector<boxprobe::BakeStateLook>& looks);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  /// The document changed or work went on. Cheap where nothing else to show came of it.
  void update();
  /// Models of another scene are shown: files baked beside it are used where they hold; once those that do not hold are
  /// captured again, the user is told.
  void useFilesBeside();
  QToolButton* addButton(const QString& text, const char* name, const QString& toolTip, void (BakePanel::*action)());
  void bake(const std::vector<std::string>& names);
  QString chooseFolder();
  void saveNext();
  void tellStale();
  void stop();

  Workspace& workspace_;
  Editor& editor_;
  SceneRenderer& renderer_;
  RenderScheduler& scheduler_;
  QLabel *mark_, *state_;
  QToolButton *bake_ = nullptr, *bakeAll_ = nullptr, *stop_ = nullptr, *save_ = nullptr;
  std::vector<BakeStateLook> shown_;
  std::string pictureError_;
  bool checkFiles_ = false;  ///< there are files beside the scene, and nothing was said of them yet

  QString folder_;                   ///< being saved to
  std::vector<std::string> toSave_;  ///< still, last first
  int saved_ = 0;
  QStringList notFinished_;
};

}  // namespace boxprobe
