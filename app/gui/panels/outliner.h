// The scene as a tree at the window's left: what is selected there is selected in the picture, and the other way. An
// eye and a lock per row, a field that finds names, renaming in place, a menu under the right button. It scrolls and
// takes the focus only when it is used itself.
#pragma once

#include <QPersistentModelIndex>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "app/gui/panels/bake_state_look.h"
#include "app/gui/panels/outliner_model.h"

class QLineEdit;
class QMenu;
class QToolButton;
class QTreeView;

namespace boxprobe {

class ProbeCommands;
class Workspace;

class Outliner : public QWidget {
  Q_OBJECT

 public:
  Outliner(Workspace& workspace, ProbeCommands& commands);

  /// How far each probe's maps are, in the scene's order.
  void showStates(const std::vector<BakeStateLook>& looks);
  /// All probes that are listed.
  void selectAll();
  /// The selected probes, in place of whatever else is selected: one of them was asked for elsewhere.
  void showProbes();
  /// The selected probes. Where something else is selected, nothing is, and a message says what to do instead.
  void duplicateSelected();
  void deleteSelected();
  /// What can be done with that row.
  std::unique_ptr<QMenu> menuFor(const QModelIndex& row);

  QSize sizeHint() const override;
  QTreeView* tree() const { return tree_; }
  const OutlinerModel& model() const { return *model_; }

 signals:
  void probeChosen();
  void objectChosen(const QString& node);
  void lightChosen(std::size_t index);

 private:
  void update();
  void choose();
  /// If it is not what was shown last.
  void followSelection();
  void showSelection();
  void rememberSelection();
  void enableButtons();
  bool selects(std::initializer_list<OutlinerModel::Kind> kinds) const;
  /// A light or a camera.
  bool othersSelected() const;
  /// Nothing that commands on probes do not mean: object, light, camera, or a group of these.
  bool onlyProbesSelected() const;
  void toggle(const QModelIndex& mark, bool alone);
  void deselectHidden();
  void openGroups();
  void keepOpen(const QModelIndex& row, bool open);
  QToolButton* addButton(const QString& text, const QString& toolTip, const std::function<void()>& action);
  void addProbeEntries(QMenu& menu, const QModelIndex& row);
  void addViewEntries(QMenu& menu, const QModelIndex& row);
  void addCameraEntries(QMenu& menu, const QModelIndex& row);

  Workspace& workspace_;
  Editor& editor_;
  ViewState& state_;
  ProbeCommands& commands_;
  OutlinerModel* model_;
  QLineEdit* filter_;
  QTreeView* tree_;
  QToolButton *duplicate_ = nullptr, *delete_ = nullptr;
  std::vector<std::size_t> probesSelected_;  ///< as they were shown last
  ViewState::Names objectsSelected_;
  std::optional<std::size_t> probeShown_;
  std::set<std::string> shut_, opened_;  ///< groups that the user has closed or opened, by kind and name
  bool choosing_ = false;                ///< the tree's own selection is on its way to the document
  bool opening_ = false;                 ///< groups are opened as they were
};

}  // namespace boxprobe
