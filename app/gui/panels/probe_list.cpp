// See probe_list.h.
#include "app/gui/panels/probe_list.h"

#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "app/session/fit_scene.h"
#include "filters/vtk/widgets/handle_drag.h"

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
    : QWidget(parent),
      editor_(editor),
      hooks_(std::move(hooks)),
      list_(new QListWidget(this)),
      filter_(new QLineEdit(this)) {
  filter_->setObjectName("probeFilter");
  filter_->setPlaceholderText(tr("Find a probe"));
  filter_->setClearButtonEnabled(true);
  filter_->setToolTip(tr("Lists only the probes that have this in their name"));
  connect(filter_, &QLineEdit::textChanged, this, [this] {
    filter();
    deselectHidden();
  });
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(72);
  list_->setMaximumHeight(120);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setToolTip(tr("Click to select, with Ctrl or Shift several, double-click or F2 to rename, Delete to remove"));

  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->addWidget(addButton(tr("Add"),
                               tr("Adds a probe captured at the centre of the view, with its box fitted to the scene"),
                               &ProbeList::addProbe));
  duplicate_ =
      addButton(tr("Duplicate"), tr("Copies the selected probes, a little aside (Ctrl+D)"), &ProbeList::duplicateProbe);
  delete_ = addButton(tr("Delete"), tr("Removes the selected probes (Delete)"), &ProbeList::deleteProbe);
  buttons->addWidget(duplicate_);
  buttons->addWidget(delete_);
  buttons->addStretch(1);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(filter_);
  layout->addWidget(list_);
  layout->addLayout(buttons);

  connect(list_, &QListWidget::itemChanged, this, &ProbeList::rename);
  // Which comes first differs between mouse, keys and calls; what both say in the end is the same.
  connect(list_, &QListWidget::currentRowChanged, this, &ProbeList::choose);
  connect(list_, &QListWidget::itemSelectionChanged, this, &ProbeList::choose);
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
  if (!choosing_) showSelection();
  markShown();
  filter();
  duplicate_->setEnabled(selected.has_value());
  delete_->setEnabled(selected.has_value());
}

// A handful needs no search.
void ProbeList::filter() {
  constexpr int kFew = 6;
  filter_->setVisible(list_->count() > kFew || !filter_->text().isEmpty());
  const QString wanted = filter_->text().trimmed();
  for (int row = 0; row < list_->count(); ++row) {
    const bool hidden = !list_->item(row)->text().contains(wanted, Qt::CaseInsensitive);
    if (list_->isRowHidden(row) != hidden) list_->setRowHidden(row, hidden);
  }
}

std::vector<std::size_t> ProbeList::shownOf(const std::vector<std::size_t>& rows) const {
  std::vector<std::size_t> shown;
  for (const std::size_t row : rows) {
    if (!list_->isRowHidden(static_cast<int>(row))) shown.push_back(row);
  }
  return shown;
}

// What nobody sees in the list is not edited or deleted with the others. Alone, the probe on show stays.
void ProbeList::deselectHidden() {
  const std::vector<std::size_t> selected = editor_.selected(), shown = shownOf(selected);
  if (selected.size() < 2 || shown.size() == selected.size()) return;
  const auto probe = editor_.document().selectedProbe();
  editor_.selectProbes(shown.empty() && probe ? std::vector<std::size_t>{*probe} : shown, probe);
}

void ProbeList::choose() {
  if (choosing_) return;
  choosing_ = true;  // the list is where it comes from: it shows it already
  std::vector<std::size_t> rows;
  for (const QModelIndex& index : list_->selectionModel()->selectedRows()) {
    rows.push_back(static_cast<std::size_t>(index.row()));
  }
  std::sort(rows.begin(), rows.end());
  const int current = list_->currentRow();
  // A range reaches over the rows that the search hides.
  const std::vector<std::size_t> seen = shownOf(rows);
  editor_.selectProbes(seen.empty() ? rows : seen, current < 0 ? std::nullopt : std::optional<std::size_t>(current));
  choosing_ = false;
  if (seen.empty() || seen.size() == rows.size()) return;
  const QSignalBlocker quiet(list_);
  showSelection();
}

void ProbeList::showSelection() {
  const auto shown = editor_.document().selectedProbe();
  const int row = shown ? static_cast<int>(*shown) : -1;
  if (list_->currentRow() != row) list_->setCurrentRow(row, QItemSelectionModel::NoUpdate);
  const std::vector<std::size_t> selected = editor_.selected();
  QItemSelection wanted;
  for (const std::size_t index : selected) {
    const QModelIndex at = list_->model()->index(static_cast<int>(index), 0);
    wanted.select(at, at);
  }
  list_->selectionModel()->select(wanted, QItemSelectionModel::ClearAndSelect);
}

// Of several, the one whose handles and fields are shown is set in bold.
void ProbeList::markShown() {
  const QSignalBlocker quiet(list_);
  const int bold = editor_.selected().size() > 1 ? static_cast<int>(*editor_.document().selectedProbe()) : -1;
  if (bold == bold_) return;
  for (const int row : {bold_, bold}) {
    if (row < 0 || row >= list_->count()) continue;
    QFont font = list_->item(row)->font();
    font.setBold(row == bold);
    list_->item(row)->setFont(font);
  }
  bold_ = bold;
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
    const std::vector<std::size_t> selected = editor_.selected();
    if (std::find(selected.begin(), selected.end(), row) == selected.end()) editor_.selectProbe(row);
  }
  update();
}

void ProbeList::addProbe() {
  editor_.finish();
  if (editor_.scene().models.empty()) {
    return emit editor_.failed(tr("There is nothing to capture yet: open a model or a scene first (Ctrl+O)"));
  }
  const Probe probe = newProbe(editor_.scene(), hooks_.sceneBounds(), hooks_.cameraTargetWorld());
  editor_.commit(tr("Add %1").arg(QString::fromStdString(probe.name)),
                 [probe](Scene& scene) { scene.probes.push_back(probe); });
  editor_.selectProbe(findProbe(editor_.scene(), probe.name));
  emit added();
}

// The copies stand together behind the last of what they are of.
void ProbeList::duplicateProbe() {
  editor_.finish();
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return;
  const QString from = editor_.selectedName();
  Scene after = editor_.scene();
  const std::size_t at = selected.back() + 1;
  std::vector<std::size_t> copies;
  for (const std::size_t index : selected) {
    Probe copy = besideOthers(after.probes[index], after.probes);
    copy.name = unusedProbeName(after, copy.name);
    copies.push_back(at + copies.size());
    after.probes.insert(after.probes.begin() + static_cast<std::ptrdiff_t>(copies.back()), copy);
  }
  const std::vector<Probe> all = after.probes;
  editor_.commit(tr("Duplicate %1").arg(from), [all](Scene& scene) { scene.probes = all; });
  editor_.selectProbes(copies);
}

void ProbeList::deleteProbe() {
  editor_.finish();
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return;
  editor_.commit(tr("Delete %1").arg(editor_.selectedName()), [selected](Scene& scene) {
    for (auto index = selected.rbegin(); index != selected.rend(); ++index) {
      scene.probes.erase(scene.probes.begin() + static_cast<std::ptrdiff_t>(*index));
    }
  });
  const std::size_t left = editor_.scene().probes.size();
  if (left > 0) editor_.selectProbe(std::min(selected.front(), left - 1));
}

void ProbeList::selectAll() {
  std::vector<std::size_t> all;
  for (int row = 0; row < list_->count(); ++row) {
    if (!list_->isRowHidden(row)) all.push_back(static_cast<std::size_t>(row));
  }
  if (!all.empty()) editor_.selectProbes(all, editor_.document().selectedProbe());
}

}  // namespace boxprobe
