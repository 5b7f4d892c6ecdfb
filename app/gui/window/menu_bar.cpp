// See menu_bar.h.
#include "app/gui/window/menu_bar.h"

#include <QAction>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "filters/core/scene/document.h"

namespace boxprobe {

MenuBar::MenuBar(QMainWindow* window) : QObject(window), window_(window) {
  QMenu* file = window->menuBar()->addMenu(tr("&File"));
  add(file, tr("&Open..."), QKeySequence::Open, &MenuBar::openRequested);
  recent_ = file->addMenu(tr("Open &recent"));
  add(file, tr("&Save"), QKeySequence::Save, &MenuBar::saveRequested);
  add(file, tr("Save &as..."), QKeySequence("Ctrl+Shift+S"), &MenuBar::saveAsRequested);
  file->addSeparator();
  export_ = add(file, tr("&Export image..."), QKeySequence("Ctrl+E"), &MenuBar::exportRequested);
  add(file, tr("Export &probes..."), {}, &MenuBar::exportProbesRequested);
  add(file, tr("Save &baked probes..."), {}, &MenuBar::saveBakedRequested);
  file->addSeparator();
  add(file, tr("&Quit"), QKeySequence("Ctrl+Q"), &MenuBar::quitRequested);

  QMenu* edit = window->menuBar()->addMenu(tr("&Edit"));
  undo_ = add(edit, tr("&Undo"), QKeySequence("Ctrl+Z"), &MenuBar::undoRequested);
  redo_ = add(edit, tr("&Redo"), QKeySequence("Ctrl+Shift+Z"), &MenuBar::redoRequested);
  edit->addSeparator();
  add(edit, tr("&Add probe"), QKeySequence("Ctrl+Shift+A"), &MenuBar::addRequested);
  duplicate_ = add(edit, tr("&Duplicate probe"), QKeySequence("Ctrl+D"), &MenuBar::duplicateRequested);
  delete_ = add(edit, tr("De&lete probe"), QKeySequence::Delete, &MenuBar::deleteRequested);
  edit->addSeparator();
  add(edit, tr("&Fit box"), QKeySequence("Ctrl+F"), &MenuBar::fitRequested);
  bake_ = add(edit, tr("&Bake probe"), QKeySequence("F5"), &MenuBar::bakeRequested);
  add(edit, tr("Ba&ke all probes"), QKeySequence("Shift+F5"), &MenuBar::bakeAllRequested);
  edit->addSeparator();
  add(edit, tr("Cancel the drag or stop capturing"), QKeySequence("Esc"), &MenuBar::escapePressed);

  view_ = window->menuBar()->addMenu(tr("&View"));
  cameras_ = view_->addMenu(tr("&Camera"));
  variants_ = view_->addMenu(tr("&Material variant"));
  variants_->setObjectName("variants");
  variants_->setEnabled(false);
  add(view_, tr("&Reset view"), QKeySequence("Home"), &MenuBar::resetViewRequested);
  view_->addSeparator();
  boxes_ = addToggle(view_, tr("Probe &boxes and handles"), QKeySequence("Ctrl+B"), &MenuBar::boxesShown);
  reflections_ = addToggle(view_, tr("Re&flections from probes"), QKeySequence("Ctrl+R"), &MenuBar::reflectionsShown);
  boxes_->setObjectName("showBoxes");
  reflections_->setObjectName("showReflections");
  motionPreview_ = addToggle(view_, tr("C&heaper techniques while moving"), {}, &MenuBar::motionPreviewSwitched);
  motionPreview_->setToolTip(tr("Draws expensive techniques by a cheaper one while the camera or a handle moves"));
  motionPreview_->setChecked(false);
  projector_ = addToggle(view_, tr("&Projector: the picture and the lesson alone"), QKeySequence("F11"),
                         &MenuBar::projectorSwitched);
  projector_->setChecked(false);
  view_->addSeparator();

  QMenu* debug = window->menuBar()->addMenu(tr("&Debug"));
  explain_ = addToggle(debug, tr("&Explain pixels"), QKeySequence("E"), &MenuBar::explainToolSwitched);
  explain_->setChecked(false);
  debug->addSeparator();
  add(debug, tr("&Copy explanation as text"), QKeySequence("Ctrl+Shift+C"), &MenuBar::copyTextRequested);
  add(debug, tr("Copy explanation as &JSON"), QKeySequence("Ctrl+Shift+J"), &MenuBar::copyJsonRequested);
  add(debug, tr("Save &rays..."), QKeySequence(), &MenuBar::saveRaysRequested);

  QMenu* help = window->menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Lessons..."), QKeySequence("F1"), &MenuBar::lessonsRequested);
  add(help, tr("&Mouse and keys, about"), QKeySequence("Shift+F1"), &MenuBar::aboutRequested);
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

void MenuBar::showExplainTool(bool on) {
  explain_->setChecked(on);
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

void MenuBar::update(const Document& document) {
  const auto withLabel = [](const QString& verb, const std::string& label) {
    return label.empty() ? verb : verb + ": " + QString::fromStdString(label).replace('&', "&&");
  };
  undo_->setEnabled(document.canUndo());
  undo_->setText(withLabel(tr("&Undo"), document.canUndo() ? document.undoLabel() : ""));
  redo_->setEnabled(document.canRedo());
  redo_->setText(withLabel(tr("&Redo"), document.canRedo() ? document.redoLabel() : ""));
  duplicate_->setEnabled(document.selectedProbe().has_value());
  delete_->setEnabled(document.selectedProbe().has_value());
  bake_->setEnabled(document.selectedProbe().has_value());

  std::vector<std::string> names;
  for (const Camera& camera : document.scene().cameras) names.push_back(camera.name);
  if (names == cameraNames_) return;
  cameraNames_ = names;
  cameras_->clear();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int index = static_cast<int>(i);
    QAction* action = cameras_->addAction(QString::fromStdString(names[i]).replace('&', "&&"));
    if (index < 9) action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(index + 1)));
    connect(action, &QAction::triggered, this, [this, index] { emit cameraChosen(index); });
  }
  cameras_->setEnabled(!names.empty());
}

}  // namespace boxprobe
