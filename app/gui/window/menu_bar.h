// The menus: what can be done, under which name and key. Emits what was chosen; does nothing itself. Called by the main
// window.
#pragma once

#include <QObject>
#include <QStringList>
#include <string>
#include <vector>

class QAction;
class QMainWindow;
class QMenu;

namespace boxprobe {

class Document;

class MenuBar : public QObject {
  Q_OBJECT

 public:
  explicit MenuBar(QMainWindow* window);

  /// The document changed: labels of undo and redo, what can be chosen, the scene's cameras.
  void update(const Document& document);
  void addDockToggle(QAction* action);
  void showRecent(const QStringList& paths);
  /// Names of the model's other sets of materials; `shown` may be empty, for its own.
  void showVariants(const QStringList& names, const QString& shown);
  void showMotionPreview(bool on);
  /// As if the user had switched them.
  void setBoxesShown(bool shown);
  void setReflectionsShown(bool shown);
  bool boxesAreShown() const;
  bool reflectionsAreShown() const;
  void showProjector(bool on);
  /// The tool was switched elsewhere.
  void showExplainTool(bool on);

 signals:
  void openRequested();
  void saveRequested();
  void saveAsRequested();
  void exportRequested();
  void exportProbesRequested();
  void saveBakedRequested();
  void recentChosen(const QString& path);
  void variantChosen(const QString& name);
  void quitRequested();
  void undoRequested();
  void redoRequested();
  void addRequested();
  void duplicateRequested();
  void deleteRequested();
  void fitRequested();
  void bakeRequested();
  void bakeAllRequested();
  void escapePressed();
  void cameraChosen(int index);
  void resetViewRequested();
  void boxesShown(bool shown);
  void reflectionsShown(bool shown);
  void motionPreviewSwitched(bool on);
  void explainToolSwitched(bool on);
  void copyTextRequested();
  void copyJsonRequested();
  void saveRaysRequested();
  void aboutRequested();
  void lessonsRequested();
  void projectorSwitched(bool on);

 private:
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)());
  QAction* addToggle(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)(bool));

  QMainWindow* window_;
  QMenu* view_;
  QMenu* cameras_;
  QMenu* recent_;
  QMenu* variants_;
  std::vector<std::string> cameraNames_;
  QAction *undo_, *redo_, *duplicate_, *delete_, *bake_, *export_, *explain_, *motionPreview_, *boxes_, *reflections_,
      *projector_;
};

}  // namespace boxprobe
