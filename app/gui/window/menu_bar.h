// The menus: what can be done, under which name and key. Emits what was chosen; does nothing itself. Called by the main
// window.
#pragma once

#include <QObject>
#include <QStringList>
#include <string>
#include <vector>

#include "filters/vtk/widgets/handle.h"

class QAction;
class QActionGroup;
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
  /// So many probes are selected: what the commands on them are called.
  void showSelected(std::size_t count);
  void addDockToggle(QAction* action);
  void showRecent(const QStringList& paths);
  /// Names of the model's other sets of materials; `shown` may be empty, for its own.
  void showVariants(const QStringList& names, const QString& shown);
  void showMotionPreview(bool on);
  void showRefinement(bool on);
  /// As if the user had switched them.
  void setBoxesShown(bool shown);
  void setReflectionsShown(bool shown);
  bool boxesAreShown() const;
  bool reflectionsAreShown() const;
  void showProjector(bool on);
  void showCutaway(bool on);
  /// What the surfaces can be coloured by, the picture itself first.
  void addSurfaceViews(const QStringList& names);
  void showSurfaceView(int view);
  void showHandleMode(HandleMode mode);
  void showCompare(bool active);
  void showViews(bool on);
  void showTheme(int theme);
  void showTone(int tone);
  void showSurroundings(int background, bool groundShadow, bool ambientOcclusion);
  void showDifference(bool on);
  /// What can be done with the selected probe, for other menus.
  std::vector<QAction*> probeActions() const { return {frame_, lookFrom_, fit_, bake_, duplicate_, copy_, delete_}; }
  /// Those of them that act on the probe even while an object is selected.
  std::vector<QAction*> probeActionsBesideObject() const { return {lookFrom_, fit_, bake_, copy_}; }
  /// Whether it runs.
  void showLiveLink(bool on);
  /// The tool was switched elsewhere.
  void showExplainTool(bool on);

 signals:
  void openRequested();
  void reloadRequested();
  void skyRequested();
  void saveRequested();
  void saveAsRequested();
  void exportRequested();
  void exportProbesRequested();
  void liveLinkRequested(bool on);
  void saveBakedRequested();
  void reportRequested();
  void recentChosen(const QString& path);
  void variantChosen(const QString& name);
  void quitRequested();
  void undoRequested();
  void redoRequested();
  void historyChosen(int position);
  void toneChosen(int tone);
  void backgroundChosen(int background);
  void groundShadowSwitched(bool on);
  void ambientOcclusionSwitched(bool on);
  void skyLeftRequested();
  void skyRightRequested();
  void brighterRequested();
  void darkerRequested();
  void exposeRequested();
  void selectHereRequested();
  void addRequested();
  void duplicateRequested();
  void deleteRequested();
  void selectAllRequested();
  void fitRequested();
  void placeRequested();
  void bakeRequested();
  void bakeAllRequested();
  void escapePressed();
  void copyRequested();
  void pasteRequested();
  void cameraChosen(int index);
  void storeCameraRequested();
  void updateCameraRequested(int index);
  void renameCameraRequested(int index);
  void deleteCameraRequested(int index);
  void frameRequested();
  void hideRequested();
  void showAllRequested();
  void isolateRequested();
  void cutawaySwitched(bool on);
  void lookFromProbeRequested();
  void lookAlongChosen(const boxprobe::BoxFace& face);
  void walkSwitched(bool on);
  void keysSwitched(bool shown);
  void holdRequested();
  void traceRequested();
  void traceReflectionRequested();
  void traceErrorRequested();
  void differenceSwitched(bool on);
  void flipSwitched(bool flipped);
  void compareEnded();
  void viewsSwitched(bool on);
  void resetViewRequested();
  void handleModeChosen(boxprobe::HandleMode mode);
  void boxesShown(bool shown);
  void reflectionsShown(bool shown);
  void motionPreviewSwitched(bool on);
  void refinementSwitched(bool on);
  void explainToolSwitched(bool on);
  void copyTextRequested();
  void copyJsonRequested();
  void saveRaysRequested();
  void surfaceViewChosen(int view);
  void countersSwitched(bool shown);
  void aboutRequested();
  void lessonsRequested();
  void projectorSwitched(bool on);
  void themeChosen(int theme);

 private:
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)());
  QAction* addToggle(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)(bool));

  void buildHandles(QMenu* edit);
  void buildLook();
  void buildShown();
  void buildCompare();
  void buildThemes();
  void buildExposure();
  void fillCameras();
  void fillHistory();

  QMainWindow* window_;
  const Document* document_ = nullptr;  ///< as of the last update()
  std::vector<QAction*> handleModes_;   ///< in the order of HandleMode
  QMenu* view_;
  QMenu* cameras_;
  QMenu* recent_;
  QMenu* history_;
  QMenu* surfaces_;
  QActionGroup* surfaceViews_;
  QActionGroup* tones_;        ///< in the order of Tone
  QActionGroup* backgrounds_;  ///< in the order of Background
  QAction* groundShadow_;
  QAction* ambientOcclusion_;
  QActionGroup* themes_;  ///< in the order of Theme
  QMenu* variants_;
  std::vector<std::string> cameraNames_;
  QAction *undo_, *redo_, *duplicate_, *delete_, *copy_, *fit_, *frame_, *lookFrom_, *keys_, *flip_, *difference_,
      *endCompare_, *views_, *bake_, *export_, *explain_, *motionPreview_, *refinement_, *boxes_, *reflections_,
      *projector_, *liveLink_, *cutaway_;
};

}  // namespace boxprobe
