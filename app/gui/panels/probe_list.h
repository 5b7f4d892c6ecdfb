// The scene's probes by name: select one or several, add, duplicate, delete, and rename in place. Called by the main
// window; the menu calls its actions too.
#pragma once

#include <QWidget>
#include <cstddef>
#include <functional>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/panels/bake_state_look.h"

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace boxprobe {

class ProbeList : public QWidget {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<glm::dvec3()> cameraTargetWorld;  ///< where a new probe is captured
    std::function<Box()> sceneBounds;               ///< what its box is fitted to
  };

  ProbeList(Editor& editor, Hooks hooks, QWidget* parent = nullptr);

  /// The document changed.
  void update();

  /// How far each probe's maps are, in the scene's order.
  void showStates(const std::vector<boxprobe::BakeStateLook>& looks);

  void addProbe();
  void duplicateProbe();
  void deleteProbe();
  void selectAll();
  QListWidget* list() const { return list_; }

 signals:
  /// By addProbe; it is selected.
  void added();

 private:
  void rename(QListWidgetItem* item);
  void choose();
  void showSelection();
  void markShown();
  void filter();
  void deselectHidden();
  std::vector<std::size_t> shownOf(const std::vector<std::size_t>& rows) const;
  QToolButton* addButton(const QString& text, const QString& toolTip, void (ProbeList::*action)());

  Editor& editor_;
  Hooks hooks_;
  QListWidget* list_;
  QLineEdit* filter_;
  QToolButton *duplicate_ = nullptr, *delete_ = nullptr;
  int bold_ = -1;          ///< row
  bool choosing_ = false;  ///< the list's own selection is on its way to the document
};

}  // namespace boxprobe
