// See camera_menu.h.
#include "app/gui/window/camera_menu.h"

#include <QInputDialog>

#include "app/gui/view/picture_work.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/workspace.h"

namespace boxprobe {

CameraMenu::CameraMenu(Workspace& workspace, QWidget* window)
    : QObject(window), workspace_(workspace), window_(window) {
  workspace.changes().add("camera menu", {&Changes::cameras, &Changes::models}, [this](const Changes&) { update(); });
  connect(&workspace.editor(), &Editor::settled, this, &CameraMenu::update);
  fill();
}

void CameraMenu::update() {
  std::vector<std::string> names;
  for (const Camera& camera : workspace_.editor().scene().cameras) names.push_back(camera.name);
  if (names == names_) return;
  names_ = names;
  fill();
}

// What edits cameras is done later: it makes the menu anew.
void CameraMenu::fill() {
  QMenu* cameras = workspace_.actions().cameras;
  for (QMenu* menu : cameras->findChildren<QMenu*>()) menu->deleteLater();
  cameras->clear();
  const auto offer = [this](QMenu* menu, Qt::ConnectionType when, const auto& work) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      QAction* action = menu->addAction(QString::fromStdString(names_[i]).replace('&', "&&"));
      connect(
          action, &QAction::triggered, this, [work, index = static_cast<int>(i)] { work(index); }, when);
    }
    menu->setEnabled(!names_.empty());
  };
  offer(cameras, Qt::DirectConnection, [this](int index) { workspace_.picture().showCamera(index); });
  const QList<QAction*> looks = cameras->actions();
  for (int i = 0; i < looks.size() && i < 9; ++i) looks[i]->setShortcut(QKeySequence(QString("Ctrl+%1").arg(i + 1)));
  cameras->setEnabled(true);
  cameras->addSeparator();
  QAction* store = cameras->addAction(tr("&Store this view..."));
  store->setShortcut(QKeySequence("Ctrl+K"));
  connect(store, &QAction::triggered, this, &CameraMenu::store, Qt::QueuedConnection);
  offer(cameras->addMenu(tr("&Move here")), Qt::QueuedConnection,
        [this](int index) { workspace_.views().updateCamera(index); });
  offer(cameras->addMenu(tr("&Rename")), Qt::QueuedConnection, [this](int index) { rename(index); });
  offer(cameras->addMenu(tr("&Delete")), Qt::QueuedConnection,
        [this](int index) { workspace_.views().deleteCamera(index); });
}

void CameraMenu::store() {
  bool accepted = false;
  const QString name = QInputDialog::getText(window_, tr("Store this view"), tr("Name of the camera"),
                                             QLineEdit::Normal, tr("view"), &accepted);
  if (accepted) workspace_.views().storeCamera(name);
}

void CameraMenu::rename(int index) {
  if (static_cast<std::size_t>(index) >= names_.size()) return;
  bool accepted = false;
  const QString was = QString::fromStdString(names_[static_cast<std::size_t>(index)]);
  const QString name =
      QInputDialog::getText(window_, tr("Rename camera"), tr("Name of the camera"), QLineEdit::Normal, was, &accepted);
  if (accepted) workspace_.views().renameCamera(index, name);
}

}  // namespace boxprobe
