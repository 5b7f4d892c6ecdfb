// See outliner.h.
#include "app/gui/panels/outliner.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/probe_commands.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/shown_parts.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/search_field.h"

namespace boxprobe {

namespace {

using Kind = OutlinerModel::Kind;
using Part = ViewState::Part;

/// Clicks on eyes and locks select nothing; it scrolls by its own keys alone.
class Tree : public QTreeView {
 public:
  using QTreeView::QTreeView;
  std::function<void(const QModelIndex&, bool alone)> marked;
  std::function<void(const QModelIndex&)> entered;

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    const QModelIndex at = indexAt(event->pos());
    if (at.isValid() && at.column() != OutlinerModel::kName) {
      if (event->button() == Qt::LeftButton) marked(at, event->modifiers().testFlag(Qt::ControlModifier));
      return event->accept();
    }
    QTreeView::mousePressEvent(event);
  }
  void mouseDoubleClickEvent(QMouseEvent* event) override {
    const QModelIndex at = indexAt(event->pos());
    if (at.isValid() && at.column() != OutlinerModel::kName) return mousePressEvent(event);
    QTreeView::mouseDoubleClickEvent(event);
  }
  void mouseReleaseEvent(QMouseEvent* event) override {
    const QModelIndex at = indexAt(event->pos());
    if (at.isValid() && at.column() != OutlinerModel::kName) return event->accept();
    QTreeView::mouseReleaseEvent(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && state() != EditingState) {
      if (currentIndex().isValid()) entered(currentIndex());
      return event->accept();
    }
    const QModelIndex before = currentIndex();
    QTreeView::keyPressEvent(event);
    if (currentIndex() != before) scrollTo(currentIndex());
  }
};

/// Rows as a selection in which neighbours are one range: Qt's time grows with the square of their number.
QItemSelection inRuns(const QModelIndexList& rows) {
  std::map<QModelIndex, std::set<int>> places;  // by parent
  for (const QModelIndex& row : rows) places[row.parent()].insert(row.row());
  QItemSelection runs;
  for (const auto& [parent, numbers] : places) {
    const QAbstractItemModel& model = *rows.front().model();
    const auto add = [&, within = parent](int first, int last) {
      runs.select(model.index(first, OutlinerModel::kName, within), model.index(last, OutlinerModel::kName, within));
    };
    int first = *numbers.begin(), last = first;
    for (const int number : numbers) {
      if (number > last + 1) add(first, last), first = number;
      last = number;
    }
    add(first, last);
  }
  return runs;
}

}  // namespace

Outliner::Outliner(Workspace& workspace, ProbeCommands& commands)
    : workspace_(workspace),
      editor_(workspace.editor()),
      state_(workspace.state()),
      commands_(commands),
      model_(new OutlinerModel(state_, this)),
      filter_(new SearchField(this)) {
  filter_->setObjectName("outlinerFilter");
  filter_->setPlaceholderText(tr("Find a name"));
  filter_->setClearButtonEnabled(true);
  filter_->setToolTip(tr("Lists only what has this in its name"));
  connect(filter_, &QLineEdit::textChanged, this, [this] {
    update();
    deselectHidden();
  });

  auto* tree = new Tree(this);
  tree_ = tree;
  tree_->setObjectName("outlinerTree");
  tree_->setAccessibleName(tr("Outliner"));
  tree_->setModel(model_);
  tree_->setHeaderHidden(true);
  tree_->setUniformRowHeights(true);
  tree_->setTextElideMode(Qt::ElideMiddle);  // names of one room differ at their end
  tree_->setIndentation(14);
  tree_->setAutoScroll(false);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setExpandsOnDoubleClick(false);
  tree_->setAllColumnsShowFocus(true);
  tree_->setMinimumWidth(190);
  QHeaderView* header = tree_->header();
  header->setStretchLastSection(false);
  header->setMinimumSectionSize(24);
  header->setSectionResizeMode(OutlinerModel::kName, QHeaderView::Stretch);
  for (const int column : {OutlinerModel::kEye, OutlinerModel::kLock}) {
    header->setSectionResizeMode(column, QHeaderView::Fixed);
    header->resizeSection(column, 26);
  }
  tree->marked = [this](const QModelIndex& at, bool alone) { toggle(at, alone); };
  tree->entered = [this](const QModelIndex& row) {
    if (model_->kind(row) == Kind::Camera) return workspace_.picture().showCamera(static_cast<int>(model_->place(row)));
    if (model_->isGroup(row)) return tree_->setExpanded(row, !tree_->isExpanded(row));
    workspace_.views().frameSelection();
  };
  connect(tree_, &QTreeView::customContextMenuRequested, this, [this](const QPoint& at) {
    const QModelIndex row = tree_->indexAt(at).siblingAtColumn(OutlinerModel::kName);
    if (!row.isValid()) return;
    if (!tree_->selectionModel()->isSelected(row)) tree_->setCurrentIndex(row);
    const auto menu = menuFor(row);
    if (!menu->isEmpty()) menu->exec(tree_->viewport()->mapToGlobal(at));
  });
  connect(tree_, &QTreeView::expanded, this, [this](const QModelIndex& row) { keepOpen(row, true); });
  connect(tree_, &QTreeView::collapsed, this, [this](const QModelIndex& row) { keepOpen(row, false); });

  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->addWidget(addButton(tr("Add"),
                               tr("Adds a probe captured at the centre of the view, with its box fitted to the scene"),
                               [this] { commands_.addProbe(); }));
  duplicate_ = addButton(tr("Duplicate"), tr("Copies the selected probes, a little aside (Ctrl+D)"),
                         [this] { duplicateSelected(); });
  delete_ = addButton(tr("Delete"), tr("Removes the selected probes (Delete)"), [this] { deleteSelected(); });
  buttons->addWidget(duplicate_);
  buttons->addWidget(delete_);
  buttons->addStretch(1);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(filter_);
  layout->addWidget(tree_, 1);
  layout->addLayout(buttons);

  connect(model_, &OutlinerModel::modelReset, this, [this] {
    openGroups();
    showSelection();
  });
  connect(model_, &OutlinerModel::renamed, this, [this](const QModelIndex& row, const QString& name) {
    const std::size_t place = model_->place(row);
    // Later: the rows may be made anew, under the field that was typed into.
    QMetaObject::invokeMethod(
        this,
        [this, place, name, camera = model_->kind(row) == Kind::Camera] {
          camera ? workspace_.views().renameCamera(static_cast<int>(place), name) : commands_.rename(place, name);
        },
        Qt::QueuedConnection);
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &Outliner::choose);
  connect(&editor_, &Editor::probesAsked, this, &Outliner::showProbes);
  connect(&state_, &ViewState::changed, this, [this] {
    model_->stateChanged();
    followSelection();
  });
  connect(&workspace, &Workspace::modelsReplaced, this, [this] { model_->setModels(workspace_.models()); });
  connect(&workspace.handles(), &ProbeWidget::taken, this, &Outliner::showProbes);
  const Actions& actions = workspace.actions();
  connect(actions.duplicate, &QAction::triggered, this, &Outliner::duplicateSelected);
  connect(actions.remove, &QAction::triggered, this, &Outliner::deleteSelected);
  connect(actions.selectAll, &QAction::triggered, this, &Outliner::selectAll);
  using C = Changes;
  workspace.changes().add("outliner",
                          {&C::probeList, &C::selection, &C::materials, &C::lights, &C::cameras, &C::models},
                          [this](const C&) { update(); });
  connect(&editor_, &Editor::selectionChanged, this, &Outliner::update);
  update();
}

// Names of a usual length, an eye and a lock: what is wider is taken from the picture.
QSize Outliner::sizeHint() const {
  return {230, QWidget::sizeHint().height()};
}

QToolButton* Outliner::addButton(const QString& text, const QString& toolTip, const std::function<void()>& action) {
  auto* button = new QToolButton(this);
  button->setObjectName(text);
  button->setText(text);
  button->setToolTip(toolTip);
  connect(button, &QToolButton::clicked, this, action);
  return button;
}

void Outliner::showStates(const std::vector<BakeStateLook>& looks) {
  model_->showStates(looks);
}

void Outliner::update() {
  const bool renamed = model_->show(editor_.scene(), filter_->text().trimmed());
  renamed && !choosing_ && !othersSelected() ? showSelection() : followSelection();
  enableButtons();
}

void Outliner::enableButtons() {
  const bool probes = !editor_.selected().empty() && onlyProbesSelected();
  duplicate_->setEnabled(probes);
  delete_->setEnabled(probes);
}

void Outliner::showProbes() {
  if (choosing_) return;
  state_.selectObjects({});
  showSelection();
}

// Probes are open at first, cameras and lights too; long lists of objects only once they are asked for, or searched.
void Outliner::openGroups() {
  opening_ = true;
  const bool finding = !filter_->text().trimmed().isEmpty();
  const std::function<void(const QModelIndex&)> open = [&](const QModelIndex& parent) {
    for (int i = 0; i < model_->rowCount(parent); ++i) {
      const QModelIndex row = model_->index(i, OutlinerModel::kName, parent);
      if (!model_->isGroup(row)) continue;
      const Kind kind = model_->kind(row);
      const std::string key = std::to_string(static_cast<int>(kind)) + model_->name(row);
      const bool usual = kind != Kind::Objects && kind != Kind::Lamps;
      tree_->setExpanded(row, finding || (usual ? shut_.count(key) == 0 : opened_.count(key) > 0));
      open(row);
    }
  };
  open({});
  opening_ = false;
}

void Outliner::keepOpen(const QModelIndex& row, bool open) {
  if (opening_ || !filter_->text().trimmed().isEmpty()) return;
  const std::string key = std::to_string(static_cast<int>(model_->kind(row))) + model_->name(row);
  open ? shut_.erase(key) : opened_.erase(key);
  (open ? opened_ : shut_).insert(key);
}

// A group stands for what is in it.
void Outliner::choose() {
  if (choosing_) return;
  choosing_ = true;  // the tree is where it comes from: it shows it already
  std::vector<std::size_t> probes;
  ViewState::Names nodes;
  std::optional<std::size_t> shown;
  const QModelIndex current = tree_->currentIndex();
  const std::function<void(const QModelIndex&)> take = [&](const QModelIndex& row) {
    const Kind kind = model_->kind(row);
    if (kind == Kind::Room || kind == Kind::Probes) {
      for (int i = 0; i < model_->rowCount(row); ++i) take(model_->index(i, OutlinerModel::kName, row));
    }
    if (kind == Kind::Probe) probes.push_back(model_->place(row));
    if (kind == Kind::Object || kind == Kind::Lamp) nodes.insert(model_->name(row));
  };
  for (const QModelIndex& row : tree_->selectionModel()->selectedRows()) take(row);
  std::sort(probes.begin(), probes.end());
  probes.erase(std::unique(probes.begin(), probes.end()), probes.end());
  if (current.isValid() && model_->kind(current) == Kind::Probe) shown = model_->place(current);
  if (!probes.empty()) editor_.selectProbes(probes, shown ? shown : editor_.document().selectedProbe());
  state_.selectObjects(nodes);
  if (current.isValid() && tree_->selectionModel()->isSelected(current)) {
    const Kind kind = model_->kind(current);
    if (kind == Kind::Object || kind == Kind::Lamp) {
      emit objectChosen(QString::fromStdString(model_->name(current)));
    }
    if (kind == Kind::Light) emit lightChosen(model_->place(current));
    if (kind == Kind::Probe) emit probeChosen();
  }
  const auto selected = editor_.document().selectedProbe();
  model_->markShown(editor_.selected().size() > 1 && selected ? static_cast<int>(*selected) : -1);
  rememberSelection();
  enableButtons();
  choosing_ = false;
}

void Outliner::rememberSelection() {
  probesSelected_ = editor_.selected();
  objectsSelected_ = state_.objects();
  probeShown_ = editor_.document().selectedProbe();
}

bool Outliner::selects(std::initializer_list<Kind> kinds) const {
  const QModelIndexList rows = tree_->selectionModel()->selectedRows();
  return std::any_of(rows.begin(), rows.end(), [&](const QModelIndex& row) {
    return std::find(kinds.begin(), kinds.end(), model_->kind(row)) != kinds.end();
  });
}

bool Outliner::othersSelected() const {
  return selects({Kind::Light, Kind::Camera});
}

bool Outliner::onlyProbesSelected() const {
  return state_.objects().empty() && !othersSelected() &&
         !selects({Kind::Objects, Kind::Lamps, Kind::Lights, Kind::Cameras});
}

void Outliner::duplicateSelected() {
  if (onlyProbesSelected()) return commands_.duplicateProbe();
  emit workspace_.message(tr("Only probes can be duplicated; select one"));
}

void Outliner::deleteSelected() {
  if (onlyProbesSelected()) return commands_.deleteProbe();
  const ViewState::Names& objects = state_.objects();
  if (objects.size() == 1) {
    emit workspace_.message(tr("%1 is part of the model and cannot be deleted; H hides it in this window")
                                .arg(QString::fromStdString(*objects.begin())));
  } else if (!objects.empty()) {
    emit workspace_.message(tr("Objects are part of the model and cannot be deleted; H hides them in this window"));
  } else if (selects({Kind::Light})) {
    emit workspace_.message(tr("A light is deleted in the panel Sky and lights"));
  } else if (selects({Kind::Camera})) {
    emit workspace_.message(tr("A camera is deleted in its menu (right click)"));
  } else {
    emit workspace_.message(tr("Select a probe to delete"));
  }
}

// Rows of lights and cameras stay selected while they are edited: nothing else says that they are not.
void Outliner::followSelection() {
  const bool same = probesSelected_ == editor_.selected() && objectsSelected_ == state_.objects() &&
                    probeShown_ == editor_.document().selectedProbe();
  if (!choosing_ && !same) showSelection();
}

void Outliner::showSelection() {
  choosing_ = true;
  const auto selected = editor_.document().selectedProbe();
  const std::vector<std::size_t> probes = editor_.selected();
  rememberSelection();
  QModelIndexList rows;
  QModelIndex current;
  if (!state_.objects().empty()) {
    for (const std::string& node : state_.objects()) {
      if (const QModelIndex row = model_->object(node); row.isValid()) rows.push_back(row), current = row;
    }
  } else {
    const std::set<std::size_t> meant(probes.begin(), probes.end());
    for (const std::size_t place : meant) {
      if (const QModelIndex row = model_->probe(place); row.isValid()) rows.push_back(row);
    }
    if (selected) current = model_->probe(*selected);
  }
  model_->markShown(probes.size() > 1 && selected ? static_cast<int>(*selected) : -1);
  QItemSelectionModel* selection = tree_->selectionModel();
  if (current.isValid() && tree_->currentIndex() != current) {
    selection->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
  }
  selection->select(inRuns(rows), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  enableButtons();
  choosing_ = false;
}

void Outliner::selectAll() {
  const std::vector<std::size_t> all = model_->probesShown();
  state_.selectObjects({});
  if (!all.empty()) editor_.selectProbes(all, editor_.document().selectedProbe());
}

// What nobody sees in the list is not edited or deleted with the others. Alone, the probe on show stays.
void Outliner::deselectHidden() {
  const std::vector<std::size_t> selected = editor_.selected(), listed = model_->probesShown();
  std::vector<std::size_t> left;
  std::set_intersection(selected.begin(), selected.end(), listed.begin(), listed.end(), std::back_inserter(left));
  if (selected.size() < 2 || left.size() == selected.size()) return;
  const auto probe = editor_.document().selectedProbe();
  editor_.selectProbes(left.empty() && probe ? std::vector<std::size_t>{*probe} : left, probe);
}

// Of a row that is selected with others: all of them.
void Outliner::toggle(const QModelIndex& mark, bool alone) {
  const QModelIndex row = mark.siblingAtColumn(OutlinerModel::kName);
  QModelIndexList rows{row};
  if (tree_->selectionModel()->isSelected(row)) rows = tree_->selectionModel()->selectedRows();
  ViewState::Names names[2];
  for (const QModelIndex& each : rows) {
    for (const Part part : {Part::Probe, Part::Object}) {
      const ViewState::Names under = model_->namesUnder(each, part);
      names[static_cast<int>(part)].insert(under.begin(), under.end());
    }
  }
  const ViewState::Names &probes = names[0], &objects = names[1];
  if (probes.empty() && objects.empty()) return;
  if (mark.column() == OutlinerModel::kEye && alone) {
    workspace_.shown().isolate(probes, objects);
    return;
  }
  const auto any = [&](const auto& holds) {
    return std::any_of(probes.begin(), probes.end(), [&](const auto& name) { return holds(Part::Probe, name); }) ||
           std::any_of(objects.begin(), objects.end(), [&](const auto& name) { return holds(Part::Object, name); });
  };
  if (mark.column() == OutlinerModel::kEye) {
    const bool hide = any([this](Part part, const std::string& name) { return state_.shown(part, name); });
    workspace_.shown().setHidden(probes, objects, hide);
  } else {
    const bool lock = any([this](Part part, const std::string& name) { return !state_.locked(part, name); });
    state_.setLocked(Part::Probe, probes, lock);
    state_.setLocked(Part::Object, objects, lock);
  }
}

void Outliner::addProbeEntries(QMenu& menu, const QModelIndex& row) {
  connect(menu.addAction(tr("&Rename")), &QAction::triggered, this,
          [this, at = QPersistentModelIndex(row)] { tree_->edit(at); });
  menu.addSeparator();
  for (QAction* action : workspace_.actions().ofProbe()) menu.addAction(action);
}

void Outliner::addViewEntries(QMenu& menu, const QModelIndex& row) {
  menu.addSeparator();
  const auto offer = [&](const QString& text, int column, bool alone) {
    connect(menu.addAction(text), &QAction::triggered, this, [this, at = QPersistentModelIndex(row), column, alone] {
      toggle(QModelIndex(at).siblingAtColumn(column), alone);
    });
  };
  const Part part = model_->namesUnder(row, Part::Probe).empty() ? Part::Object : Part::Probe;
  const ViewState::Names names = model_->namesUnder(row, part);
  if (names.empty()) return;
  const bool shown = std::any_of(names.begin(), names.end(), [&](const auto& n) { return state_.shown(part, n); });
  const bool locked = std::all_of(names.begin(), names.end(), [&](const auto& n) { return state_.locked(part, n); });
  offer(shown ? tr("&Hide") : tr("&Show"), OutlinerModel::kEye, false);
  if (model_->isGroup(row)) {
    offer(state_.isolated() ? tr("Show the &others again") : tr("Show it a&lone"), OutlinerModel::kEye, true);
  } else {
    connect(menu.addAction(state_.isolated() ? tr("Show the &others again") : tr("Show it a&lone")),
            &QAction::triggered, &workspace_.shown(), &ShownParts::toggleIsolation);
  }
  offer(locked ? tr("&Unlock") : tr("Loc&k"), OutlinerModel::kLock, false);
  if (state_.anyHidden()) {
    connect(menu.addAction(tr("Show &all hidden")), &QAction::triggered, &state_, &ViewState::showAll);
  }
}

void Outliner::addCameraEntries(QMenu& menu, const QModelIndex& row) {
  const int place = static_cast<int>(model_->place(row));
  connect(menu.addAction(tr("&Look through it")), &QAction::triggered, this,
          [this, place] { workspace_.picture().showCamera(place); });
  connect(menu.addAction(tr("&Rename")), &QAction::triggered, this,
          [this, at = QPersistentModelIndex(row)] { tree_->edit(at); });
  connect(
      menu.addAction(tr("&Delete")), &QAction::triggered, this,
      [this, place] { workspace_.views().deleteCamera(place); }, Qt::QueuedConnection);
}

std::unique_ptr<QMenu> Outliner::menuFor(const QModelIndex& row) {
  auto menu = std::make_unique<QMenu>(this);
  const Kind kind = model_->kind(row);
  if (kind == Kind::Probe) addProbeEntries(*menu, row);
  if (kind == Kind::Object || kind == Kind::Lamp) {
    connect(menu->addAction(tr("&Frame")), &QAction::triggered, &workspace_.views(), &ViewCommands::frameSelection);
  }
  if (kind == Kind::Camera) addCameraEntries(*menu, row);
  addViewEntries(*menu, row);
  return menu;
}

}  // namespace boxprobe
