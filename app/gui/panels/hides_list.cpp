// See hides_list.h.
#include "app/gui/panels/hides_list.h"

#include <QCheckBox>
#include <QMenu>
#include <QWidgetAction>
#include <algorithm>

#include "app/gui/widgets/message_box.h"

namespace boxprobe {

HidesList::HidesList(QWidget* parent) : QToolButton(parent), menu_(new QMenu(this)) {
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMenu(menu_);
  menu_->setStyleSheet("QMenu { menu-scrollable: 1; }");
  connect(menu_, &QMenu::aboutToShow, this, &HidesList::fillMenu);
  show({});
}

void HidesList::setNodes(const std::vector<std::string>& nodes) {
  nodes_ = nodes;
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  nodes_.erase(std::remove(nodes_.begin(), nodes_.end(), std::string()), nodes_.end());
}

void HidesList::show(const std::vector<std::string>& hidden) {
  hidden_ = hidden;
  QStringList names;
  for (const std::string& node : hidden_) names.push_back(QString::fromStdString(node));
  setText(names.isEmpty()     ? tr("No object")
          : names.size() <= 2 ? names.join(", ")
                              : tr("%1 and %2 more").arg(names.front()).arg(names.size() - 1));
  setToolTip(names.isEmpty() ? tr("Objects this probe does not see, such as one at its origin. Default: none")
                             : plainToolTip(tr("Not seen by this probe: %1").arg(names.join(", "))));
}

void HidesList::fillMenu() {
  menu_->clear();
  std::vector<std::string> names = nodes_;
  for (const std::string& node : hidden_) {
    if (std::find(names.begin(), names.end(), node) == names.end()) names.push_back(node);
  }
  // Check boxes in place of plain actions: the menu stays open while several are ticked.
  for (const std::string& node : names) {
    auto* box = new QCheckBox(QString::fromStdString(node).replace('&', "&&"), menu_);
    box->setObjectName(QString::fromStdString(node));
    box->setContentsMargins(6, 2, 12, 2);
    box->setChecked(std::find(hidden_.begin(), hidden_.end(), node) != hidden_.end());
    connect(box, &QCheckBox::clicked, this, [this, node](bool hide) { toggle(node, hide); });
    auto* action = new QWidgetAction(menu_);
    action->setDefaultWidget(box);
    menu_->addAction(action);
  }
  if (names.empty()) menu_->addAction(tr("The model's objects have no names"))->setEnabled(false);
}

void HidesList::toggle(const std::string& node, bool hide) {
  std::vector<std::string> next = hidden_;
  next.erase(std::remove(next.begin(), next.end(), node), next.end());
  if (hide) next.push_back(node);
  emit changed(next);
}

}  // namespace boxprobe
