// See actions.h.
#include "app/gui/widgets/actions.h"

#include <QKeySequence>
#include <QMenuBar>
#include <QRegularExpression>

#include "app/gui/widgets/table_words.h"
#include "app/gui/widgets/tool_icons.h"
#include "filters/core/geometry/probe_frame.h"
#include "filters/core/scene/surface_view.h"

namespace boxprobe {

Actions::Actions(QMenuBar* bar) : QObject(bar) {
  static const QRegularExpression kLetter("\\(&.\\)|&");  // to press with Alt, behind the text in Chinese
  const auto setMode = [this](int mode, ToolIcon icon, const QString& tip) {
    QAction* action = handleModes->actions()[mode];
    const QString key = QString::number(mode + 1);
    action->setIcon(toolIcon(icon));
    action->setIconText(action->text().remove(kLetter));
    action->setObjectName("handles" + key);
    action->setShortcut(QKeySequence(key));
    action->setToolTip(tip + " (" + key + ")");
  };
  setMode(0, ToolIcon::Box,
          tr("Handles on the faces of the projection box: a filled ball at the maximum, a hollow one at the minimum"));
  setMode(1, ToolIcon::Influence,
          tr("Balls on the influence box, cubes on the box inside which the probe has its full weight"));
  setMode(2, ToolIcon::Origin, tr("Arrows at the capture origin"));
  setMode(3, ToolIcon::Place, tr("Moves and turns the whole probe"));
  for (const BoxFace& face : kBoxFaces) {
    const QString shortcut = QString(face.positive ? "Alt+%1" : "Alt+Shift+%1").arg("XYZ"[face.axis]);
    addChoice(axes, tr("From %1").arg(QString(faceName(face))), shortcut)->setCheckable(false);
  }
  for (const SurfaceViewRow& row : boxprobe::surfaceViews()) {
    const auto number = surfaceViews->actions().size();
    addChoice(surfaceViews, tableWords(row.label), number < 10 ? QString("Alt+%1").arg(number) : QString());
  }
  showChoice(handleModes, 0);
  showChoice(surfaceViews, 0);
  variants->setEnabled(false);
}

QAction* Actions::add(const QString& text, const char* shortcuts, const QString& tip) {
  auto* action = new QAction(text, this);
  if (*shortcuts != '\0') action->setShortcuts(QKeySequence::listFromString(shortcuts));
  if (!tip.isEmpty()) action->setToolTip(tip);
  // Keys work while the menu bar is hidden.
  static_cast<QMenuBar*>(parent())->window()->addAction(action);
  return action;
}

QAction* Actions::addSwitch(Start start, const QString& text, const char* shortcuts, const QString& tip,
                            const char* name) {
  QAction* action = add(text, shortcuts, tip);
  action->setObjectName(name);
  action->setCheckable(true);
  action->setChecked(start == On);
  return action;
}

QActionGroup* Actions::addChoices(const QStringList& texts) {
  auto* group = new QActionGroup(this);
  for (const QString& text : texts) addChoice(group, text);
  return group;
}

QAction* Actions::addChoice(QActionGroup* group, const QString& text, const QString& shortcut) {
  QAction* action = add(text);
  action->setShortcut(QKeySequence(shortcut));
  action->setCheckable(true);
  action->setData(static_cast<int>(group->actions().size()));
  group->addAction(action);
  return action;
}

QMenu* Actions::addMenu(const QString& title, const char* name) {
  auto* menu = new QMenu(title, static_cast<QMenuBar*>(parent()));
  menu->setObjectName(name);
  return menu;
}

void showChoice(const QActionGroup* group, int place) {
  const auto actions = group->actions();
  if (place >= 0 && place < actions.size()) actions[place]->setChecked(true);
}

}  // namespace boxprobe
