// See menu_bar.h.
#include "app/gui/window/menu_bar.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <algorithm>
#include <string>
#include <vector>

#include "app/gui/view/workspace.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/window/about_dialog.h"
#include "app/gui/window/language_menu.h"

namespace boxprobe {

MenuBar::MenuBar(Workspace& workspace, QMainWindow* window) : QObject(window), workspace_(workspace) {
  arrange(window);
  const Actions& actions = workspace.actions();
  Editor* editor = &workspace.editor();
  connect(actions.quit, &QAction::triggered, window, &QWidget::close);
  connect(actions.undo, &QAction::triggered, editor, &Editor::undo);
  connect(actions.redo, &QAction::triggered, editor, &Editor::redo);
  connect(actions.history, &QMenu::aboutToShow, this, &MenuBar::fillHistory);
  connect(actions.about, &QAction::triggered, window, [window] { showAbout(window); });
  showChoice(actions.themes, chosenTheme().value_or(static_cast<int>(Theme::System)));
  connect(actions.themes, &QActionGroup::triggered, this, [](const QAction* chosen) {
    const int theme = chosen->data().toInt();
    keepTheme(theme);
    applyWindowStyle(*qApp, static_cast<Theme>(theme));
  });
  workspace.changes().add("menu", ChangeKinds::all(), [this](const Changes&) { update(); });
  connect(editor, &Editor::settled, this, &MenuBar::update);
  connect(editor, &Editor::selectionChanged, this, &MenuBar::nameProbeActions);
}

void MenuBar::arrange(QMainWindow* window) {
  const Actions& a = workspace_.actions();
  QMenuBar* bar = window->menuBar();

  QMenu* file = bar->addMenu(tr("&File"));
  file->addActions({a.open, a.recent->menuAction(), a.reload, a.sky, a.save, a.saveAs});
  file->addSeparator();
  file->addActions({a.exportImage, a.exportProbes, a.liveLink, a.saveBaked, a.report});
  file->addSeparator();
  file->addAction(a.quit);

  QMenu* edit = bar->addMenu(tr("&Edit"));
  edit->addActions({a.undo, a.redo, a.history->menuAction()});
  edit->addSeparator();
  edit->addActions({a.addProbe, a.duplicate, a.remove, a.copy, a.paste, a.selectAll, a.selectHere});
  edit->addSeparator();
  edit->addActions({a.fit, a.place, a.bake, a.bakeAll});
  edit->addMenu(tr("&Handles"))->addActions(a.handleModes->actions());
  edit->addSeparator();
  edit->addAction(a.escape);

  QMenu* view = a.view;
  bar->addMenu(view);
  const auto addMenu = [view](const QString& title, const QList<QAction*>& actions, const char* name = "") {
    QMenu* menu = view->addMenu(title);
    menu->setObjectName(name);
    menu->addActions(actions);
  };
  view->addActions({a.cameras->menuAction(), a.variants->menuAction(), a.resetView, a.frame, a.lookFrom});
  addMenu(tr("Look &along an axis"), a.axes->actions());
  view->addActions({a.walk, a.hide, a.showAll, a.isolate, a.cutaway});
  addMenu(tr("C&ompare"),
          {a.hold, a.trace, a.traceReflection, a.traceError, a.difference, a.flip, a.sideBySide, a.stopComparing});
  addMenu(tr("E&xposure"), {a.brighter, a.darker, a.expose});
  addMenu(tr("To&ne mapping"), a.tones->actions(), "tones");
  addMenu(tr("Turn the s&ky"), {a.skyLeft, a.skyRight});
  addMenu(tr("Back&ground"), a.backgrounds->actions(), "backgrounds");
  view->addActions({a.groundShadow, a.ambientOcclusion});
  view->addSeparator();
  view->addActions({a.boxes, a.reflections, a.motionPreview, a.refinement, a.projector});
  addMenu(tr("&Theme"), a.themes->actions(), "themes");
  addLanguageMenu(view, window);
  view->addSeparator();
  view->addAction(a.lessons);

  QMenu* debug = bar->addMenu(tr("&Debug"));
  debug->addAction(a.explain);
  QMenu* surfaces = debug->addMenu(tr("&Surfaces coloured by"));
  surfaces->setObjectName("surfaceViews");
  surfaces->addActions(a.surfaceViews->actions());
  debug->addSeparator();
  debug->addActions({a.copyText, a.copyJson, a.saveRays});
  debug->addSeparator();
  debug->addAction(a.counters);

  bar->addMenu(tr("Hel&p"))->addActions({a.lessons, a.keys, a.about});

  auto* tools = new QToolBar(tr("Tools"), window);
  tools->setObjectName("tools");
  tools->setMovable(false);
  tools->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  window->addToolBar(tools);
  tools->addActions(a.handleModes->actions());
}

// The newest first, as one looks for them; the mark stands where the scene stands.
void MenuBar::fillHistory() {
  constexpr int kMostSteps = 30;
  QMenu* history = workspace_.actions().history;
  const std::vector<std::string> labels = workspace_.document().stepLabels();
  const int count = static_cast<int>(labels.size()), position = static_cast<int>(workspace_.document().position());
  history->clear();
  const int last = std::max(0, std::min(count, position + kMostSteps / 2) - kMostSteps);
  for (int step = std::min(count, last + kMostSteps); step >= last && count > 0; --step) {
    const QString text =
        step == 0 ? tr("As opened") : QString::fromStdString(labels[static_cast<std::size_t>(step) - 1]);
    QAction* action = history->addAction(QString(text).replace('&', "&&"));
    action->setCheckable(true);
    action->setChecked(step == position);
    connect(
        action, &QAction::triggered, this, [this, step] { workspace_.editor().goTo(static_cast<std::size_t>(step)); },
        Qt::QueuedConnection);
  }
}

void MenuBar::nameProbeActions() {
  const Actions& actions = workspace_.actions();
  const std::size_t count = workspace_.editor().selected().size();
  const QString probes = count > 1 ? tr("%1 probes").arg(count) : tr("probe");
  actions.duplicate->setText(tr("&Duplicate %1").arg(probes));
  actions.remove->setText(tr("De&lete %1").arg(probes));
  actions.copy->setText(tr("&Copy %1").arg(probes));
  actions.bake->setText(tr("&Bake %1").arg(probes));
}

void MenuBar::update() {
  const Actions& actions = workspace_.actions();
  const Document& document = workspace_.document();
  const auto withLabel = [](const QString& verb, const std::string& label) {
    return label.empty() ? verb : verb + ": " + QString::fromStdString(label).replace('&', "&&");
  };
  actions.undo->setEnabled(document.canUndo());
  actions.undo->setText(withLabel(tr("&Undo"), document.canUndo() ? document.undoLabel() : ""));
  actions.redo->setEnabled(document.canRedo());
  actions.redo->setText(withLabel(tr("&Redo"), document.canRedo() ? document.redoLabel() : ""));
  actions.history->setEnabled(document.canUndo() || document.canRedo());
  for (QAction* action : actions.ofProbe()) action->setEnabled(document.selectedProbe().has_value());
  actions.frame->setEnabled(true);
  nameProbeActions();
}

}  // namespace boxprobe
