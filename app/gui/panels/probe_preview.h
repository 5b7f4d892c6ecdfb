// What the selected probe holds: any level of its maps as a cross or a latitude-longitude picture, its distances, and a
// sphere in the 3D view. Called by the main window. Reads nothing while it is hidden, and once for each map otherwise,
// a face a turn of the event loop.
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "app/gui/edit/editor.h"
#include "filters/vtk/maps/level_reader.h"

class QComboBox;
class QLabel;
class QSlider;

namespace boxprobe {

class CubeFaces;
class SceneRenderer;
class Workspace;
class ValueField;

class ProbePreview : public QWidget {
  Q_OBJECT

 public:
  explicit ProbePreview(Workspace& workspace);

  /// Whether anyone can see it. A dock behind another's tab still counts as visible for Qt.
  void setWatched(bool watched);
  /// The document or a probe's maps may have changed. Cheap where they have not.
  void update();
  /// Faces read back since the start: what looking has cost.
  int facesRead() const { return facesRead_; }
  /// Nothing left to read.
  bool idle() const { return !reader_.pending() && !timer_.isActive(); }

 private:
  void buildFields();
  void start();
  void readOne();
  void draw();
  void updateLevelText();
  void updateSphere();
  void tell(const std::optional<glm::vec3>& direction);
  bool showsDistance() const;
  int level() const;

  Workspace& workspace_;
  Editor& editor_;
  SceneRenderer& renderer_;
  CubeFaces* view_;
  QLabel* readout_;
  QComboBox *what_ = nullptr, *kind_ = nullptr, *sphere_ = nullptr;
  QSlider* level_ = nullptr;
  QLabel* levelText_ = nullptr;
  ValueField* stops_ = nullptr;

  QTimer timer_;
  LevelReader reader_;
  CubeMap cube_;  ///< what is shown
  double farthest_ = 0.0;
  int facesRead_ = 0;
  bool watched_ = false;
  /// What was read, or is being read.
  std::string probe_;
  std::weak_ptr<const ProbeMaps> maps_;
  int readLevel_ = -1;
  bool readDistance_ = false;
  double exposure_ = -1.0;
};

}  // namespace boxprobe
