// Which objects a probe does not see: a line that says so, and a menu of all objects to tick. Called by the capture
// panel; knows no document.
#pragma once

#include <QToolButton>
#include <string>
#include <vector>

class QMenu;

namespace boxprobe {

class HidesList : public QToolButton {
  Q_OBJECT

 public:
  explicit HidesList(QWidget* parent = nullptr);

  /// The objects to choose from; names that come more than once hide all objects of that name.
  void setNodes(const std::vector<std::string>& nodes);
  /// What the document holds; no signal. Names that are no object's can still be taken off.
  void show(const std::vector<std::string>& hidden);

 signals:
  void changed(const std::vector<std::string>& hidden);

 private:
  void fillMenu();
  void toggle(const std::string& node, bool hide);

  QMenu* menu_;
  std::vector<std::string> nodes_;  ///< sorted, each once
  std::vector<std::string> hidden_;
};

}  // namespace boxprobe
