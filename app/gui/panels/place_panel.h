// Finds the rooms of the scene, places probes in them and compares pictures with the path tracer's, in a thread of its
// own with a renderer of its own. Only what measured better is proposed: drawn as ghosts, reviewed in a list with
// pictures before and after, and accepted probe by probe or all together, as one undo step.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "app/gui/edit/editor.h"
#include "app/session/picture_check.h"
#include "filters/core/scene/model.h"
#include "filters/fit/place_probes.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace boxprobe {

class PlacedList;
class Workspace;

class PlacePanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlacePanel(Workspace& workspace);

  /// How finely pictures are traced; `views` is set in any case.
  void setPaths(int paths) { paths_ = paths; }
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
  struct Result {
    Placement placement;
    std::optional<PictureCheck> pictures;
    QString notCompared;  ///< why there are no pictures; empty: there are
  };
  /// What would be placed, or is the scene's own and would be changed.
  struct Proposed {
    Probe probe;
    bool own = false;
  };
  /// The document changed: a result for what is no longer so is dropped.
  void update();
  void review(Result result);
  std::vector<Proposed> accepted() const;
  std::vector<Probe> ghosts() const;
  void refresh();

  Workspace& workspace_;
  Editor& editor_;
  std::vector<std::shared_ptr<const Model>> models_;
  QPushButton *place_, *apply_, *discard_;
  QLabel *errors_, *remarks_;
  PlacedList* list_;
  QCheckBox* replace_;
  QWidget* review_;
  int paths_ = PictureCheckSettings{}.paths;
  Scene given_;  ///< what probes are placed in, or were
  std::optional<std::vector<Proposed>> result_;
  BackgroundWork work_;  ///< last: it ends before what it would tell of it
};

}  // namespace boxprobe
