// See frame_panel.h.
#include "app/gui/panels/frame_panel.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/edit/field_form.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/table_words.h"
#include "filters/core/base/errors.h"
#include "filters/core/scene/surface_view.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr std::size_t kListed = 200;  // rows of a kind; a thousand are nobody's to read

QString text(const std::string& string) {
  return QString::fromStdString(string);
}

QString megabytes(std::size_t bytes) {
  return QObject::tr("%1 MiB").arg(static_cast<double>(bytes) / 1048576.0, 0, 'f', 2);
}

QString percent(double share) {
  return QString::number(100.0 * share, 'f', 0) + " %";
}

void addRowTo(QTreeWidgetItem* parent, const QString& name, const QString& value, const QString& toolTip = {}) {
  auto* row = new QTreeWidgetItem(parent, {name, value});
  if (value.isEmpty()) row->setFirstColumnSpanned(true);
  row->setToolTip(0, plainToolTip(toolTip.isEmpty() ? name : toolTip));
}

}  // namespace

FramePanel::FramePanel(Workspace& workspace)
    : workspace_(workspace),
      editor_(workspace.editor()),
      summary_(helpLabel(this)),
      tree_(new QTreeWidget(this)),
      count_(new QPushButton(tr("Count lookups"), this)),
      heatMap_(new QPushButton(tr("Heat map"), this)),
      costs_(new QPushButton(tr("Measure costs"), this)),
      objectPart_(new QWidget(this)),
      objectName_(new QLabel(this)),
      mode_(new QuietCombo(this)),
      weights_(new QuietCombo(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  auto* buttons = new QHBoxLayout;
  count_->setObjectName("countLookups");
  count_->setToolTip(tr("Draws the picture again and counts the cubemap lookups of each pixel"));
  heatMap_->setObjectName("heatMap");
  heatMap_->setCheckable(true);
  heatMap_->setToolTip(
      tr("Colours the surfaces by their number of lookups, like the view \"Lookups\" of the Debug tab"));
  buttons->addWidget(count_);
  costs_->setObjectName("measureCosts");
  costs_->setToolTip(
      tr("Draws the picture many times with parts of it left out, and tells how much time each part takes"));
  buttons->addWidget(heatMap_);
  buttons->addWidget(costs_);
  buttons->addStretch(1);
  column->addLayout(buttons);
  summary_->setObjectName("frameSummary");
  column->addWidget(summary_);
  tree_->setObjectName("frameTree");
  tree_->setColumnCount(2);
  tree_->header()->hide();
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  column->addWidget(tree_, 1);

  objectPart_->setLayout(new QVBoxLayout);
  objectPart_->layout()->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(objectPart_, tr("Object"));
  mode_->setObjectName("probeMode");
  mode_->addItems(
      {tr("Off: the sky alone"), tr("Simple: one probe, no blending"), tr("Blend probes"), tr("Blend probes and sky")});
  weights_->setObjectName("objectWeights");
  weights_->addItems({tr("At each pixel"), tr("One for the object")});
  form->addRow(tr("Name"), objectName_);
  const auto& mode = objectField("probeMode");
  const auto& weights = objectField("weights");
  addRow(form, tr("Probes"), mode_, fieldTip(mode));
  addRow(form, tr("Weights"), weights_, fieldTip(weights));
  for (int i = 0; i < mode_->count(); ++i) mode_->setItemData(i, choiceTip(mode, i), Qt::ToolTipRole);
  for (int i = 0; i < weights_->count(); ++i) weights_->setItemData(i, choiceTip(weights, i), Qt::ToolTipRole);
  column->addWidget(objectPart_);
  objectPart_->hide();

  connect(count_, &QPushButton::clicked, this, &FramePanel::countLookups);
  connect(costs_, &QPushButton::clicked, this, &FramePanel::measureCosts);
  const auto views = workspace.actions().surfaceViews->actions();
  QAction* lookups = views[*findSurfaceView("lookups")];
  connect(heatMap_, &QPushButton::toggled, this,
          [lookups, none = views.front()](bool on) { (on ? lookups : none)->trigger(); });
  connect(lookups, &QAction::toggled, this, [this](bool shown) {
    const QSignalBlocker quiet(heatMap_);
    heatMap_->setChecked(shown);
  });
  connect(&workspace.scheduler(), &RenderScheduler::rendered, this, &FramePanel::update);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, &FramePanel::selectionChanged);
  connect(mode_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    changeObject(tr("Set probes of %1").arg(text(object_)),
                 [index](ObjectOverride& object) { object.probeUsage = static_cast<ProbeUsage>(index); });
  });
  connect(weights_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    changeObject(tr("Set weights of %1").arg(text(object_)),
                 [index](ObjectOverride& object) { object.weights = static_cast<WeightMode>(index); });
  });
}

void FramePanel::changeObject(const QString& label, const std::function<void(ObjectOverride&)>& change) {
  if (object_.empty()) return;
  editor_.commit(label, [name = object_, change](Scene& scene) {
    ObjectOverride& object = scene.objects[name];
    change(object);
    if (object == ObjectOverride{}) scene.objects.erase(name);
  });
}

void FramePanel::setWatched(bool watched) {
  watched_ = watched;
  update();
}

void FramePanel::update() {
  if (!watched_) return;
  fill(workspace_.renderer().frameReport());
  showModes();
}

void FramePanel::countLookups() {
  vtkGenericOpenGLRenderWindow* window = workspace_.viewport().window3d();
  window->MakeCurrent();
  const int* size = window->GetSize();
  const FrameReport::Lookups lookups = workspace_.renderer().measureLookups(size[0], size[1]);
  workspace_.requestPicture();
  summary_->setText(
      tr("Lookups per pixel: mean %1, at most %2.").arg(lookups.mean, 0, 'f', 2).arg(lookups.most, 0, 'f', 0));
}

FrameCosts FramePanel::costs() {
  constexpr int kRounds = 5;
  QProgressDialog shown(tr("Measuring where the time of a frame goes ..."), tr("Stop"), 0, 100, this);
  shown.setObjectName("costsProgress");
  shown.setWindowModality(Qt::ApplicationModal);
  shown.setMinimumDuration(0);
  FrameCosts costs;
  try {
    costs = measureFrameCosts(
        workspace_.renderer(), kRounds, [this] { return timedFrameOf(workspace_.viewport().window3d()); },
        [&shown](double fraction) {
          shown.setValue(static_cast<int>(99.0 * fraction));
          return !shown.wasCanceled();
        });
  } catch (const Error& error) {
    emit workspace_.failed(QString::fromUtf8(error.what()));
  }
  workspace_.requestPicture();
  return costs;
}

void FramePanel::measureCosts() {
  const FrameCosts costs = this->costs();
  if (costs.parts.empty()) return;
  summary_->setText((costs.cpuTime ? tr("A frame takes %1 ms of CPU time (all threads).") : tr("A frame takes %1 ms."))
                        .arg(costs.frame.median, 0, 'f', 1));
  const QSignalBlocker quiet(tree_);
  const auto add = [&costs](QTreeWidgetItem* parent, const QString& name, const Cost& cost, const QString& help) {
    const double share = costs.frame.median > 0.0 ? cost.median / costs.frame.median : 0.0;
    addRowTo(parent, name, QString::number(cost.median, 'f', 1) + QObject::tr(" ms, ") + percent(share),
             QObject::tr("%1. Quartiles: %2 to %3 ms").arg(help).arg(cost.low, 0, 'f', 2).arg(cost.high, 0, 'f', 2));
  };
  QTreeWidgetItem* parts = section(tr("Costs of the frame"));
  for (const FrameCosts::Row& row : costs.parts) add(parts, tableWords(row.name), row.cost, tableWords(row.help));
  add(parts, tr("of these, drawn over"), costs.overdraw, tr("Pixels that are worked out and then covered"));
  QTreeWidgetItem* objects = section(tr("Costs of objects' pixels"));
  for (const FrameCosts::Row& row : costs.objects) add(objects, text(row.name), row.cost, text(row.name));
}

QTreeWidgetItem* FramePanel::section(const QString& title) {
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = tree_->topLevelItem(i);
    if (item->data(0, Qt::UserRole).toString() != title) continue;
    qDeleteAll(item->takeChildren());
    return item;
  }
  auto* item = new QTreeWidgetItem(tree_, {title});
  item->setData(0, Qt::UserRole, title);
  item->setFirstColumnSpanned(true);
  item->setExpanded(true);
  return item;
}

void FramePanel::fill(const FrameReport& report) {
  const QSignalBlocker quiet(tree_);
  QTreeWidgetItem* draws = section(tr("Draws"));
  for (std::size_t count = 0; count < report.drawsByProbeCount.size(); ++count) {
    addRowTo(draws, count == 1 ? tr("with 1 probe") : tr("with %1 probes").arg(count),
             QString::number(report.drawsByProbeCount[count]));
  }
  addRowTo(draws, tr("shader variants"), QString::number(report.variants),
           tr("Objects that share a shader variant, whatever their textures"));

  QTreeWidgetItem* skipped = section(tr("Left out"));
  for (const Phrase& line : skippedLines(report)) addRowTo(skipped, phraseWords(line), {});
  for (const Phrase& line : leftOutLines(report)) addRowTo(skipped, phraseWords(line), {});

  if (!report.mirrors.empty()) {
    QTreeWidgetItem* mirrors = section(tr("Planar mirrors"));
    for (const Phrase& line : mirrorLines(report)) addRowTo(mirrors, phraseWords(line), {});
  }

  QTreeWidgetItem* objects = section(tr("Objects and their probes"));
  std::size_t listed = 0;
  for (const FrameReport::Object& object : report.objects) {
    if (!object.drawn || ++listed > kListed) continue;
    auto* item = new QTreeWidgetItem(objects, {text(object.node), object.unlit ? tr("unlit") : QString()});
    item->setData(0, Qt::UserRole + 1, text(object.node));
    item->setToolTip(
        0,
        tr("Material %1. Shares are for the object's whole bounds; they vary per pixel.").arg(text(object.material)));
    for (const FrameReport::Share& share : object.probes) addRowTo(item, text(share.probe), percent(share.weight));
    if (!object.unlit) addRowTo(item, tr("sky"), percent(object.sky));
    item->setExpanded(object.node == object_);
    if (object.node == object_) item->setSelected(true);
  }
  if (listed > kListed) addRowTo(objects, tr("and %1 more").arg(listed - kListed), {});

  QTreeWidgetItem* memory = section(tr("Memory by probe"));
  addRowTo(memory, tr("all maps, including those kept for undo"), megabytes(report.bytes));
  std::vector<FrameReport::ProbeUse> held = report.probes;
  std::stable_sort(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.bytes > b.bytes; });
  for (std::size_t i = 0; i < held.size() && i < kListed && held[i].bytes > 0; ++i) {
    addRowTo(memory, text(held[i].name), megabytes(held[i].bytes),
             (held[i].objects == 1 ? tr("lights %1 object, %2 of them in this frame")
                                   : tr("lights %1 objects, %2 of them in this frame"))
                 .arg(held[i].objects)
                 .arg(held[i].drawn));
  }
}

void FramePanel::selectionChanged() {
  const auto selected = tree_->selectedItems();
  QTreeWidgetItem* item = selected.isEmpty() ? nullptr : selected.front();
  if (item != nullptr && item->data(0, Qt::UserRole + 1).isNull() && item->parent() != nullptr) item = item->parent();
  object_ = item == nullptr ? std::string() : item->data(0, Qt::UserRole + 1).toString().toStdString();
  if (item != nullptr && !object_.empty()) item->setExpanded(true);
  showModes();
}

void FramePanel::showModes() {
  objectPart_->setVisible(!object_.empty());
  if (object_.empty()) return;
  const auto found = editor_.scene().objects.find(object_);
  const ObjectOverride object = found != editor_.scene().objects.end() ? found->second : ObjectOverride{};
  objectName_->setText(text(object_));
  mode_->setCurrentIndex(static_cast<int>(object.probeUsage));
  weights_->setCurrentIndex(static_cast<int>(object.weights));
}

}  // namespace boxprobe
