// See language_menu.h.
#include "app/gui/window/language_menu.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QRegularExpression>
#include <QStatusBar>

#include "app/gui/widgets/window_language.h"

namespace boxprobe {

void addLanguageMenu(QMenu* view, QMainWindow* window) {
  QMenu* menu = view->addMenu(QCoreApplication::translate("LanguageMenu", "Languag&e"));
  menu->setObjectName("languages");
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(menu);
  const QString chosen = chosenLanguage();
  const auto add = [&](const QString& code, const QString& name, const QString& tip) {
    QAction* action = menu->addAction(name);
    action->setObjectName("language_" + code);
    action->setCheckable(true);
    action->setChecked(code == chosen);
    action->setToolTip(tip);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, window, [window, code, name] {
      keepLanguage(code);
      window->statusBar()->showMessage(
          QCoreApplication::translate("LanguageMenu", "Language: %1, when the window is opened the next time")
              .arg(QString(name).remove(QRegularExpression("\\(&.\\)|&"))));
    });
  };
  add(QString(), QCoreApplication::translate("LanguageMenu", "&System"),
      QCoreApplication::translate("LanguageMenu", "The language of the system, if there is a translation"));
  for (const WindowLanguage& each : windowLanguages()) {
    const QString unreviewed =
        QCoreApplication::translate("LanguageMenu", "Not yet reviewed by a native speaker; corrections are welcome");
    add(each.code, each.name, each.code == "en" ? QString() : unreviewed);
  }
}

}  // namespace boxprobe
