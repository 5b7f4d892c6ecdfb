// See probe_list.h.
#include "app/gui/panels/probe_list.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "app/gui/handles/handle_drag.h"
#include "app/session/fit_scene.h"

namespace boxprobe {

namespace {

Probe newProbe(const Scene& scene, const Box& bounds, const glm::dvec3& targetWorld) {
  Probe probe = fittedProbe(bounds);
  probe.name = unusedProbeName(scene, "probe");
  // Looking past the scene must not put the origin outside of what it captures.
  probe.origin = glm::clamp(targetWorld, bounds.min + 0.05 * bounds.size(), bounds.max - 0.05 * bounds.size());
  return probe;
}

}  // namespace

ProbeList::ProbeList(Editor& editor, Hooks hooks, QWidget* parent)
    : QWidget(parent), editor_(editor), hooks_(std::move(hooks)), list_(new QListWidget(this)) {
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(72);
  list_->setMaximumHeight(120);
  list_->setToolTip(tr("Click to select, double-click or F2 to rename, Delete to remove"));

  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->addWidget(addButton(tr("Add"),
                               tr("Adds a probe captured at the centre of the view, with its box fitted to the scene"),
                               &ProbeList::addProbe));
  duplicate_ =
      addButton(tr("Duplicate"), tr("Copies the selected probe, a little aside (Ctrl+D)"), &ProbeList::duplicateProbe);
  delete_ = addButton(tr("Delete"), tr("Removes the selected probe (Delete)"), &ProbeList::deleteProbe);
  buttons->addWidget(duplicate_);
  buttons->addWidget(delete_);
  buttons->addStretch(1);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_);
  layout->addLayout(buttons);

  connect(list_, &QListWidget::itemChanged, this, &ProbeList::rename);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    editor_.selectProbe(row < 0 ? std::optional<std::size_t>() : static_cast<std::size_t>(row));
  });
  update();
}

QToolButton* ProbeList::addButton(const QString& text, const QString& toolTip, void (ProbeList::*action)()) {
  auto* button = new QToolButton(this);
  button->setObjectName(text);
  button->setText(text);
  button->setToolTip(toolTip);
  connect(button, &QToolButton::clicked, this, action);
  return button;
}

void ProbeList::update() {
  const QSignalBlocker quiet(list_);
  const auto& probes = editor_.scene().probes;
  const auto selected = editor_.document().selectedProbe();
  while (list_->count() > static_cast<int>(probes.size())) delete list_->takeItem(list_->count() - 1);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const int row = static_cast<int>(i);
    if (row >= list_->count()) {
      auto* item = new QListWidgetItem(list_);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    const QString name = QString::fromStdString(probes[i].name);
    if (list_->item(row)->text() != name) list_->item(row)->setText(name);
  }
  list_->setCurrentRow(selected ? static_cast<int>(*selected) : -1);
  duplicate_->setEnabled(selected.has_value());
  delete_->setEnabled(selected.has_value());
}

void ProbeList::showStates(const std::vector<BakeStateLook>& looks) {
  const QSignalBlocker quiet(list_);
  for (std::size_t i = 0; i < looks.size() && static_cast<int>(i) < list_->count(); ++i) {
    QListWidgetItem* item = list_->item(static_cast<int>(i));
    item->setIcon(stateIcon(looks[i]));
    item->setToolTip(looks[i].text);
  }
}

void ProbeList::rename(QListWidgetItem* item) {
  const auto row = static_cast<std::size_t>(list_->row(item));
  const auto& probes = editor_.scene().probes;
  if (row >= probes.size()) return;
  const std::string from = probes[row].name;
  const QString to = item->text().trimmed();
  const auto holder = findProbe(editor_.scene(), to.toStdString());
  if (to.isEmpty()) {
    emit editor_.failed(tr("A probe needs a name; it stays %1").arg(QString::fromStdString(from)));
  } else if (holder && *holder != row) {
    emit editor_.failed(tr("A probe named %1 already exists; each needs its own name").arg(to));
  } else if (to.toStdString() != from) {
    const std::string name = to.toStdString();
    editor_.commit(tr("Rename %1 to %2").arg(QString::fromStdString(from), to),
                   [row, name](Scene& scene) { scene.probes[row].name = name; });
    editor_.selectProbe(row);
  }
  update();
}

void ProbeList::addProbe() {
  editor_.finish();
  const Probe probe = newProbe(editor_.scene(), hooks_.sceneBounds(), hooks_.cameraTargetWorld());
  editor_.commit(tr("Add %1").arg(QString::fromStdString(probe.name)),
                 [probe](Scene& scene) { scene.probes.push_back(probe); });
  editor_.selectProbe(findProbe(editor_.scene(), probe.name));
  emit added();
}

void ProbeList::duplicateProbe() {
  editor_.finish();
  const auto selected = editor_.document().selectedProbe();
  if (!selected) return;
  Probe copy = *editor_.probe();
  const QString from = QString::fromStdString(copy.name);
  copy = besideOthers(copy, editor_.scene().probes);
  copy.name = unusedProbeName(editor_.scene(), copy.name);
  const std::size_t at = *selected + 1;
  editor_.commit(tr("Duplicate %1").arg(from), [copy, at](Scene& scene) {
    scene.probes.insert(scene.probes.begin() + static_cast<std::ptrdiff_t>(at), copy);
  });
  editor_.selectProbe(findProbe(editor_.scene(), copy.name));
}

void ProbeList::deleteProbe() {
  editor_.finish();
  const auto selected = editor_.document().selectedProbe();
  if (!selected) return;
  const std::size_t at = *selected;
  editor_.commit(tr("Delete %1").arg(QString::fromStdString(editor_.probe()->name)),
                 [at](Scene& scene) { scene.probes.erase(scene.probes.begin() + static_cast<std::ptrdiff_t>(at)); });
  const std::size_t left = editor_.scene().probes.size();
  if (left > 0) editor_.selectProbe(std::min(at, left - 1));
}

}  // namespace boxprobe
