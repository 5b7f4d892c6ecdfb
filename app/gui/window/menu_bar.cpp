// See menu_bar.h.
#include "app/gui/window/menu_bar.h"

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "app/gui/widgets/tool_icons.h"
#include "app/gui/window/language_menu.h"
#include "filters/core/scene/document.h"

namespace boxprobe {

MenuBar::MenuBar(QMainWindow* window) : QObject(window), window_(window) {
  QMenu* file = window->menuBar()->addMenu(tr("&File"));
  add(file, tr("&Open..."), QKeySequence::Open, &MenuBar::openRequested);
  recent_ = file->addMenu(tr("Open &recent"));
  add(file, tr("&Reload"), QKeySequence("Ctrl+Shift+O"), &MenuBar::reloadRequested);
  add(file, tr("S&ky from a picture..."), {}, &MenuBar::skyRequested);
  add(file, tr("&Save"), QKeySequence::Save, &MenuBar::saveRequested);
  add(file, tr("Save &as..."), QKeySequence("Ctrl+Shift+S"), &MenuBar::saveAsRequested);
  file->addSeparator();
  export_ = add(file, tr("&Export image..."), QKeySequence("Ctrl+E"), &MenuBar::exportRequested);
  add(file, tr("Export &probes..."), {}, &MenuBar::exportProbesRequested);
  liveLink_ = addToggle(file, tr("&Live link..."), {}, &MenuBar::liveLinkRequested);
  liveLink_->setChecked(false);
  add(file, tr("Save &baked probes..."), {}, &MenuBar::saveBakedRequested);
  add(file, tr("Repor&t..."), {}, &MenuBar::reportRequested)
      ->setToolTip(tr("One HTML file: every camera drawn and path traced, the probes with their fit and cost"));
  file->addSeparator();
  add(file, tr("&Quit"), QKeySequence("Ctrl+Q"), &MenuBar::quitRequested);

  QMenu* edit = window->menuBar()->addMenu(tr("&Edit"));
  undo_ = add(edit, tr("&Undo"), QKeySequence("Ctrl+Z"), &MenuBar::undoRequested);
  redo_ = add(edit, tr("&Redo"), QKeySequence("Ctrl+Shift+Z"), &MenuBar::redoRequested);
  redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  history_ = edit->addMenu(tr("&History"));
  history_->setObjectName("history");
  connect(history_, &QMenu::aboutToShow, this, &MenuBar::fillHistory);
  edit->addSeparator();
  add(edit, tr("&Add probe"), QKeySequence("Ctrl+Shift+A"), &MenuBar::addRequested);
  duplicate_ = add(edit, tr("&Duplicate probe"), QKeySequence("Ctrl+D"), &MenuBar::duplicateRequested);
  delete_ = add(edit, tr("De&lete probe"), QKeySequence::Delete, &MenuBar::deleteRequested);
  copy_ = add(edit, tr("&Copy probe"), QKeySequence::Copy, &MenuBar::copyRequested);
  add(edit, tr("&Paste probes"), QKeySequence::Paste, &MenuBar::pasteRequested);
  add(edit, tr("&Select all probes"), QKeySequence::SelectAll, &MenuBar::selectAllRequested);
  add(edit, tr("Select the probe &here"), QKeySequence("Shift+P"), &MenuBar::selectHereRequested)
      ->setToolTip(tr("The probe that lights the place where the camera stands"));
  edit->addSeparator();
  fit_ = add(edit, tr("&Fit box"), QKeySequence("Ctrl+F"), &MenuBar::fitRequested);
  add(edit, tr("&Place probes"), QKeySequence("Ctrl+Shift+F"), &MenuBar::placeRequested);
  bake_ = add(edit, tr("&Bake probe"), QKeySequence("F5"), &MenuBar::bakeRequested);
  add(edit, tr("Ba&ke all probes"), QKeySequence("Shift+F5"), &MenuBar::bakeAllRequested);
  buildHandles(edit);
  edit->addSeparator();
  add(edit, tr("Cancel the drag or stop capturing"), QKeySequence("Esc"), &MenuBar::escapePressed);

  view_ = window->menuBar()->addMenu(tr("&View"));
  cameras_ = view_->addMenu(tr("&Camera"));
  cameras_->setObjectName("cameras");
  variants_ = view_->addMenu(tr("&Material variant"));
  variants_->setObjectName("variants");
  variants_->setEnabled(false);
  add(view_, tr("&Reset view"), QKeySequence("Home"), &MenuBar::resetViewRequested);
  buildLook();
  buildShown();
  buildCompare();
  buildExposure();
  view_->addSeparator();
  boxes_ = addToggle(view_, tr("Probe &boxes and handles"), QKeySequence("Ctrl+B"), &MenuBar::boxesShown);
  reflections_ = addToggle(view_, tr("Re&flections from probes"), QKeySequence("Ctrl+R"), &MenuBar::reflectionsShown);
  boxes_->setObjectName("showBoxes");
  reflections_->setObjectName("showReflections");
  motionPreview_ = addToggle(view_, tr("C&heaper techniques while moving"), {}, &MenuBar::motionPreviewSwitched);
  motionPreview_->setToolTip(tr("Draws expensive techniques by a cheaper one while the camera or a handle moves"));
  motionPreview_->setChecked(false);
  refinement_ = addToggle(view_, tr("Refi&ne at rest"), {}, &MenuBar::refinementSwitched);
  refinement_->setToolTip(
      tr("While nothing moves, reflections go on to what rays of the whole lobe show, whatever the technique"));
  projector_ = addToggle(view_, tr("&Projector: the picture and the lesson alone"), QKeySequence("F11"),
                         &MenuBar::projectorSwitched);
  projector_->setChecked(false);
  buildThemes();
  addLanguageMenu(view_, window);
  view_->addSeparator();

  QMenu* debug = window->menuBar()->addMenu(tr("&Debug"));
  explain_ = addToggle(debug, tr("&Explain pixels"), QKeySequence("E"), &MenuBar::explainToolSwitched);
  explain_->setChecked(false);
  surfaces_ = debug->addMenu(tr("&Surfaces coloured by"));
  surfaces_->setObjectName("surfaceViews");
  surfaceViews_ = new QActionGroup(this);
  debug->addSeparator();
  add(debug, tr("&Copy explanation as text"), QKeySequence("Ctrl+Shift+C"), &MenuBar::copyTextRequested);
  add(debug, tr("Copy explanation as &JSON"), QKeySequence("Ctrl+Shift+J"), &MenuBar::copyJsonRequested);
  add(debug, tr("Save &rays..."), QKeySequence(), &MenuBar::saveRaysRequested);
  debug->addSeparator();
  QAction* counters = addToggle(debug, tr("&Work counters in the status bar"), {}, &MenuBar::countersSwitched);
  counters->setObjectName("countersShown");
  counters->setChecked(false);

  QMenu* help = window->menuBar()->addMenu(tr("Hel&p"));
  view_->addAction(add(help, tr("&Lessons..."), QKeySequence("F1"), &MenuBar::lessonsRequested));
  keys_ = addToggle(help, tr("&Keys over the picture"), {}, &MenuBar::keysSwitched);
  keys_->setShortcuts({QKeySequence("?"), QKeySequence("Shift+?")});  // where the layout has it above another letter
  keys_->setChecked(false);
  add(help, tr("&Mouse and keys, about"), QKeySequence("Shift+F1"), &MenuBar::aboutRequested);
}

void MenuBar::buildLook() {
  frame_ = add(view_, tr("&Frame the selection"), QKeySequence("F"), &MenuBar::frameRequested);
  lookFrom_ = add(view_, tr("&Look from the probe"), QKeySequence("P"), &MenuBar::lookFromProbeRequested);
  QMenu* along = view_->addMenu(tr("Look &along an axis"));
  for (const BoxFace& face : kBoxFaces) {
    QAction* action = along->addAction(tr("From %1").arg(QString(faceName(face))));
    action->setShortcut(QKeySequence(QString(face.positive ? "Alt+%1" : "Alt+Shift+%1").arg("XYZ"[face.axis])));
    window_->addAction(action);
    connect(action, &QAction::triggered, this, [this, face] { emit lookAlongChosen(face); });
  }
  QAction* walk = addToggle(view_, tr("&Walk at eye height"), QKeySequence("G"), &MenuBar::walkSwitched);
  walk->setObjectName("walk");
  walk->setChecked(false);
}

// Of the window alone: no scene file and no capture knows of it.
void MenuBar::buildShown() {
  add(view_, tr("&Hide the selection"), QKeySequence("H"), &MenuBar::hideRequested)
      ->setToolTip(tr("In this window alone; the scene's file, captures and exported pictures have it"));
  add(view_, tr("Show &all hidden"), QKeySequence("Alt+H"), &MenuBar::showAllRequested);
  add(view_, tr("&Isolate the selection"), QKeySequence("/"), &MenuBar::isolateRequested)
      ->setToolTip(tr("Of a probe: with the objects that reach into its box. Once more shows the others again"));
  cutaway_ =
      addToggle(view_, tr("Cu&t away what hides the probe's box"), QKeySequence("Alt+B"), &MenuBar::cutawaySwitched);
  cutaway_->setObjectName("cutaway");
  cutaway_->setToolTip(tr("Looks into a room from outside. Exported pictures, errors and captures are not cut"));
  cutaway_->setChecked(false);
}

void MenuBar::buildCompare() {
  QMenu* compare = view_->addMenu(tr("C&ompare"));
  add(compare, tr("&Hold this picture"), QKeySequence("C"), &MenuBar::holdRequested);
  add(compare, tr("With &all light, ray traced"), QKeySequence("Shift+C"), &MenuBar::traceRequested);
  add(compare, tr("With the &reflection alone ray traced"), {}, &MenuBar::traceReflectionRequested);
  add(compare, tr("&Error against all light, ray traced"), QKeySequence("Shift+V"), &MenuBar::traceErrorRequested);
  difference_ = addToggle(compare, tr("The &difference in false colours"), QKeySequence("Ctrl+Shift+D"),
                          &MenuBar::differenceSwitched);
  difference_->setChecked(false);
  flip_ = addToggle(compare, tr("&Flip to the other picture"), QKeySequence("V"), &MenuBar::flipSwitched);
  views_ = addToggle(compare, tr("Four &views side by side"), QKeySequence("Alt+C"), &MenuBar::viewsSwitched);
  views_->setChecked(false);
  endCompare_ = add(compare, tr("&Stop comparing"), {}, &MenuBar::compareEnded);
  showCompare(false);
}

void MenuBar::buildExposure() {
  QMenu* menu = view_->addMenu(tr("E&xposure"));
  add(menu, tr("&Brighter"), QKeySequence("]"), &MenuBar::brighterRequested);
  add(menu, tr("&Darker"), QKeySequence("["), &MenuBar::darkerRequested);
  add(menu, tr("&Expose automatically"), {}, &MenuBar::exposeRequested);
  QMenu* tones = view_->addMenu(tr("To&ne mapping"));
  tones->setObjectName("tones");
  tones_ = new QActionGroup(this);
  for (const QString& text : {tr("N&one"), tr("Khronos PBR &Neutral"), tr("&AgX"), tr("A&CES")}) {
    QAction* action = tones->addAction(text);
    action->setCheckable(true);
    tones_->addAction(action);
    const auto tone = static_cast<int>(tones_->actions().size()) - 1;
    connect(action, &QAction::triggered, this, [this, tone] { emit toneChosen(tone); });
  }
  QMenu* sky = view_->addMenu(tr("Turn the s&ky"));
  add(sky, tr("To the &left"), QKeySequence("Alt+Left"), &MenuBar::skyLeftRequested);
  add(sky, tr("To the &right"), QKeySequence("Alt+Right"), &MenuBar::skyRightRequested);
  QMenu* backgrounds = view_->addMenu(tr("Back&ground"));
  backgrounds->setObjectName("backgrounds");
  backgrounds_ = new QActionGroup(this);
  for (const QString& text : {tr("&Environment"), tr("&Blurred environment"), tr("&Grey"), tr("&Colour...")}) {
    QAction* action = backgrounds->addAction(text);
    action->setCheckable(true);
    backgrounds_->addAction(action);
    const auto background = static_cast<int>(backgrounds_->actions().size()) - 1;
    connect(action, &QAction::triggered, this, [this, background] { emit backgroundChosen(background); });
  }
  groundShadow_ = addToggle(view_, tr("Ground shado&w"), {}, &MenuBar::groundShadowSwitched);
  ambientOcclusion_ = addToggle(view_, tr("Ambient occl&usion"), {}, &MenuBar::ambientOcclusionSwitched);
}

// Without telling anybody: it is the document that they follow.
void MenuBar::showSurroundings(int background, bool groundShadow, bool ambientOcclusion) {
  const auto actions = backgrounds_->actions();
  if (background >= 0 && background < actions.size()) actions[background]->setChecked(true);
  for (const auto& [action, on] :
       {std::pair(groundShadow_, groundShadow), std::pair(ambientOcclusion_, ambientOcclusion)}) {
    const QSignalBlocker quiet(action);
    action->setChecked(on);
  }
}

void MenuBar::showTone(int tone) {
  const auto actions = tones_->actions();
  if (tone >= 0 && tone < actions.size()) actions[tone]->setChecked(true);
}

void MenuBar::buildThemes() {
  QMenu* menu = view_->addMenu(tr("&Theme"));
  menu->setObjectName("themes");
  themes_ = new QActionGroup(this);
  for (const QString& text : {tr("As the &desktop has it"), tr("D&ark"), tr("&Light")}) {
    const int theme = static_cast<int>(themes_->actions().size());
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    themes_->addAction(action);
    connect(action, &QAction::triggered, this, [this, theme] { emit themeChosen(theme); });
  }
}

void MenuBar::showTheme(int theme) {
  const auto actions = themes_->actions();
  if (theme >= 0 && theme < actions.size()) actions[theme]->setChecked(true);
}

void MenuBar::showCompare(bool active) {
  if (!active) flip_->setChecked(false);
  flip_->setEnabled(active);
  if (!active) showDifference(false);
  difference_->setEnabled(active);
  endCompare_->setEnabled(active);
}

void MenuBar::showViews(bool on) {
  views_->setChecked(on);
}

void MenuBar::fillCameras() {
  for (QMenu* menu : cameras_->findChildren<QMenu*>()) menu->deleteLater();
  cameras_->clear();
  const auto each = [this](QMenu* menu, void (MenuBar::*signal)(int), bool keys) {
    for (std::size_t i = 0; i < cameraNames_.size(); ++i) {
      const int index = static_cast<int>(i);
      QAction* action = menu->addAction(QString::fromStdString(cameraNames_[i]).replace('&', "&&"));
      if (keys && index < 9) action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(index + 1)));
      connect(action, &QAction::triggered, this, [this, signal, index] { emit(this->*signal)(index); });
    }
    menu->setEnabled(!cameraNames_.empty());
  };
  each(cameras_, &MenuBar::cameraChosen, true);
  cameras_->setEnabled(true);
  cameras_->addSeparator();
  QAction* store = cameras_->addAction(tr("&Store this view..."));
  store->setShortcut(QKeySequence("Ctrl+K"));
  connect(store, &QAction::triggered, this, &MenuBar::storeCameraRequested);
  each(cameras_->addMenu(tr("&Move here")), &MenuBar::updateCameraRequested, false);
  each(cameras_->addMenu(tr("&Rename")), &MenuBar::renameCameraRequested, false);
  each(cameras_->addMenu(tr("&Delete")), &MenuBar::deleteCameraRequested, false);
}

void MenuBar::buildHandles(QMenu* edit) {
  QMenu* menu = edit->addMenu(tr("&Handles"));
  auto* bar = new QToolBar(tr("Tools"), window_);
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  window_->addToolBar(bar);
  auto* group = new QActionGroup(this);
  const auto addMode = [&](HandleMode mode, ToolIcon icon, const QString& text, const QString& key,
                           const QString& tip) {
    QAction* action = menu->addAction(toolIcon(icon), text);
    static const QRegularExpression kLetter("\\(&.\\)|&");  // to press with Alt, behind the text in Chinese
    action->setIconText(QString(text).remove(kLetter));
    action->setObjectName("handles" + key);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(key));
    action->setToolTip(tip + " (" + key + ")");
    group->addAction(action);
    window_->addAction(action);
    bar->addAction(action);
    handleModes_.push_back(action);
    connect(action, &QAction::triggered, this, [this, mode] { emit handleModeChosen(mode); });
  };
  addMode(HandleMode::Box, ToolIcon::Box, tr("&Box"), "1",
          tr("Handles on the faces of the projection box: a filled ball at the maximum, a hollow one at the minimum"));
  addMode(HandleMode::Influence, ToolIcon::Influence, tr("&Influence"), "2",
          tr("Balls on the influence box, cubes on the box inside which the probe has its full weight"));
  addMode(HandleMode::Origin, ToolIcon::Origin, tr("&Origin"), "3", tr("Arrows at the capture origin"));
  addMode(HandleMode::Place, ToolIcon::Place, tr("&Move and turn"), "4", tr("Moves and turns the whole probe"));
  showHandleMode(HandleMode::Box);
}

void MenuBar::showDifference(bool on) {
  difference_->setChecked(on);
}

void MenuBar::showHandleMode(HandleMode mode) {
  handleModes_[static_cast<std::size_t>(mode)]->setChecked(true);
}

QAction* MenuBar::add(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)()) {
  QAction* action = menu->addAction(text);
  action->setShortcut(keys);
  window_->addAction(action);  // keys work while the menu bar is hidden
  connect(action, &QAction::triggered, this, signal);
  return action;
}

QAction* MenuBar::addToggle(QMenu* menu, const QString& text, const QKeySequence& keys, void (MenuBar::*signal)(bool)) {
  QAction* action = menu->addAction(text);
  action->setShortcut(keys);
  window_->addAction(action);
  action->setCheckable(true);
  action->setChecked(true);
  connect(action, &QAction::toggled, this, signal);
  return action;
}

void MenuBar::showVariants(const QStringList& names, const QString& shown) {
  variants_->clear();
  variants_->setEnabled(!names.isEmpty());
  const auto offer = [this, &shown](const QString& text, const QString& name) {
    QAction* action = variants_->addAction(text);
    action->setCheckable(true);
    action->setChecked(name == shown);
    connect(action, &QAction::triggered, this, [this, name] { emit variantChosen(name); });
  };
  if (!names.isEmpty()) offer(tr("The file's own"), QString());
  for (const QString& name : names) offer(QString(name).replace('&', "&&"), name);
}

void MenuBar::showLiveLink(bool on) {
  const QSignalBlocker quiet(liveLink_);
  liveLink_->setChecked(on);
}

void MenuBar::showExplainTool(bool on) {
  explain_->setChecked(on);
}

void MenuBar::showRefinement(bool on) {
  refinement_->setChecked(on);
}

void MenuBar::showMotionPreview(bool on) {
  motionPreview_->setChecked(on);
}

void MenuBar::setBoxesShown(bool shown) {
  boxes_->setChecked(shown);
}

void MenuBar::setReflectionsShown(bool shown) {
  reflections_->setChecked(shown);
}

bool MenuBar::boxesAreShown() const {
  return boxes_->isChecked();
}

bool MenuBar::reflectionsAreShown() const {
  return reflections_->isChecked();
}

void MenuBar::showProjector(bool on) {
  projector_->setChecked(on);
}

void MenuBar::showCutaway(bool on) {
  cutaway_->setChecked(on);
}

void MenuBar::addSurfaceViews(const QStringList& names) {
  for (int view = 0; view < names.size(); ++view) {
    QAction* action = surfaces_->addAction(names[view]);
    action->setCheckable(true);
    action->setChecked(view == 0);
    if (view < 10) action->setShortcut(QKeySequence(QString("Alt+%1").arg(view)));
    surfaceViews_->addAction(action);
    window_->addAction(action);
    connect(action, &QAction::triggered, this, [this, view] { emit surfaceViewChosen(view); });
  }
}

void MenuBar::showSurfaceView(int view) {
  const auto actions = surfaceViews_->actions();
  if (view >= 0 && view < actions.size()) actions[view]->setChecked(true);
}

void MenuBar::addDockToggle(QAction* action) {
  view_->addAction(action);
}

void MenuBar::showRecent(const QStringList& paths) {
  recent_->clear();
  for (int i = 0; i < paths.size(); ++i) {
    const QString path = paths[i];
    QAction* action = recent_->addAction(QString("&%1  %2").arg(i + 1).arg(QString(path).replace('&', "&&")));
    connect(action, &QAction::triggered, this, [this, path] { emit recentChosen(path); });
  }
  recent_->setEnabled(!paths.isEmpty());
}

// The newest first, as one looks for them; the mark stands where the scene stands.
void MenuBar::fillHistory() {
  if (document_ == nullptr) return;
  constexpr int kMostSteps = 30;
  const std::vector<std::string> labels = document_->stepLabels();
  const int count = static_cast<int>(labels.size()), position = static_cast<int>(document_->position());
  history_->clear();
  const int last = std::max(0, std::min(count, position + kMostSteps / 2) - kMostSteps);
  for (int step = std::min(count, last + kMostSteps); step >= last && count > 0; --step) {
    const QString text =
        step == 0 ? tr("As opened") : QString::fromStdString(labels[static_cast<std::size_t>(step) - 1]);
    QAction* action = history_->addAction(QString(text).replace('&', "&&"));
    action->setCheckable(true);
    action->setChecked(step == position);
    connect(
        action, &QAction::triggered, this, [this, step] { emit historyChosen(step); }, Qt::QueuedConnection);
  }
}

void MenuBar::showSelected(std::size_t count) {
  const QString probes = count > 1 ? tr("%1 probes").arg(count) : tr("probe");
  duplicate_->setText(tr("&Duplicate %1").arg(probes));
  delete_->setText(tr("De&lete %1").arg(probes));
  copy_->setText(tr("&Copy %1").arg(probes));
  bake_->setText(tr("&Bake %1").arg(probes));
}

void MenuBar::update(const Document& document) {
  const auto withLabel = [](const QString& verb, const std::string& label) {
    return label.empty() ? verb : verb + ": " + QString::fromStdString(label).replace('&', "&&");
  };
  undo_->setEnabled(document.canUndo());
  undo_->setText(withLabel(tr("&Undo"), document.canUndo() ? document.undoLabel() : ""));
  redo_->setEnabled(document.canRedo());
  redo_->setText(withLabel(tr("&Redo"), document.canRedo() ? document.redoLabel() : ""));
  document_ = &document;
  history_->setEnabled(document.canUndo() || document.canRedo());
  for (QAction* action : probeActions()) action->setEnabled(document.selectedProbe().has_value());
  frame_->setEnabled(true);

  std::vector<std::string> names;
  for (const Camera& camera : document.scene().cameras) names.push_back(camera.name);
  if (names == cameraNames_ && !cameras_->isEmpty()) return;
  cameraNames_ = names;
  fillCameras();
}

}  // namespace boxprobe
