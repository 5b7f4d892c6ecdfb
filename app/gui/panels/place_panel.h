// Finds the rooms of the scene and places probes in them, in a thread of its own; what is placed is drawn as ghosts,
// reviewed in a list and accepted probe by probe or all together, as one undo step. Called by the docks; the
// mathematics is filters/fit's.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"
#include "filters/fit/place_probes.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace boxprobe {

class PlacePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlacePanel(Editor& editor, QWidget* parent = nullptr);

  /// In the order of scene.models.
  void setModels(const std::vector<std::shared_ptr<const Model>>& models) { models_ = models; }
  /// The document changed: a result for what is no longer so is dropped.
  void update();

  /// Starts, or stops what is under way.
  void place();
  bool running() const { return work_.running(); }
  /// As one undo step, the probes that are ticked.
  void apply();
  void discard();

 signals:
  /// The probes that apply() would set; none: nothing is under review.
  void ghostsChanged(const std::vector<boxprobe::Probe>& ghosts);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  void review(Placement placement);
  std::vector<Probe> accepted() const;
  void refresh();

  Editor& editor_;
  std::vector<std::shared_ptr<const Model>> models_;
  QPushButton *place_, *apply_, *discard_;
  QLabel *errors_, *remarks_;
  QListWidget* list_;
  QCheckBox* replace_;
  QWidget* review_;
  Scene given_;  ///< what probes are placed in, or were
  std::optional<Placement> result_;
  BackgroundWork work_;  ///< last: it ends before what it would tell of it
};

}  // namespace boxprobe
