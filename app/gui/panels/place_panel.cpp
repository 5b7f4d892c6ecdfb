// See place_panel.h.
#include "app/gui/panels/place_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/widgets/panel_layout.h"

namespace boxprobe {

namespace {

QString errorText(double degrees) {
  return QString::number(degrees, 'f', 2) + QString::fromUtf8("\u00b0");
}

/// What was found and decided of a probe's room, one sentence a line.
QString roomText(const Placement& placement, const PlacedProbe& placed) {
  const PlacedRoom& room = placement.rooms[placed.room];
  const glm::dvec3 size = room.extent.size();
  QStringList lines = {QString::fromStdString(placed.reason), PlacePanel::tr("%1: %2 x %3 x %4")
                                                                  .arg(QString::fromStdString(room.name))
                                                                  .arg(size.x, 0, 'f', 2)
                                                                  .arg(size.y, 0, 'f', 2)
                                                                  .arg(size.z, 0, 'f', 2)};
  for (const std::string& decision : room.decisions) lines += QString::fromStdString(decision);
  for (const std::string& remark : placed.fit.remarks) lines += QString::fromStdString(remark);
  return lines.join("\n");
}

/// In all that rooms and probes follow from: the exposure, say, may be another one.
bool alike(const Scene& a, const Scene& b) {
  return a.models == b.models && a.objects == b.objects && a.materials == b.materials && a.probes == b.probes;
}

}  // namespace

PlacePanel::PlacePanel(Editor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      place_(new QPushButton(this)),
      apply_(new QPushButton(tr("Apply"), this)),
      discard_(new QPushButton(tr("Discard"), this)),
      errors_(new QLabel(this)),
      remarks_(helpLabel(this)),
      list_(new QListWidget(this)),
      replace_(new QCheckBox(tr("Replace the probes there are"), this)),
      review_(new QWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Place"));
  place_->setObjectName("placeProbes");
  place_->setToolTip(
      tr("Finds the rooms of the scene and places a fitted probe in each, and more where they gain "
         "(Ctrl+Shift+F)"));
  form->addRow(place_);
  form->addRow(remarks_);
  form->addRow(review_);

  auto* rows = new QVBoxLayout(review_);
  rows->setContentsMargins(0, 0, 0, 0);
  errors_->setObjectName("placeErrors");
  errors_->setWordWrap(true);
  errors_->setToolTip(
      tr("Angle between what reflections look up and what they should, as the probes are blended; "
         "without a probe 20 degrees"));
  rows->addWidget(errors_);
  list_->setObjectName("placedProbes");
  list_->setToolTip(tr("Untick what shall not be placed"));
  list_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the column is no wider for it
  list_->setMaximumHeight(140);
  rows->addWidget(list_);
  replace_->setObjectName("replaceProbes");
  replace_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  rows->addWidget(replace_);
  auto* buttons = new QHBoxLayout;
  apply_->setObjectName("applyPlaced");
  discard_->setObjectName("discardPlaced");
  buttons->addWidget(apply_);
  buttons->addWidget(discard_);
  rows->addLayout(buttons);

  connect(place_, &QPushButton::clicked, this, &PlacePanel::place);
  connect(apply_, &QPushButton::clicked, this, &PlacePanel::apply);
  connect(discard_, &QPushButton::clicked, this, &PlacePanel::discard);
  connect(list_, &QListWidget::itemChanged, this, [this] {
    if (result_) emit ghostsChanged(accepted());
    refresh();
  });
  connect(&work_, &BackgroundWork::progressed, this, &PlacePanel::refresh);
  connect(&work_, &BackgroundWork::ended, this, [this](bool stopped, const QString& error) {
    if (!error.isEmpty()) emit failed(error);
    if (stopped) emit message(tr("Placing was stopped"));
    refresh();
  });
  refresh();
}

void PlacePanel::place() {
  if (running()) {
    work_.stop();
    return;
  }
  if (models_.empty()) return;
  discard();
  given_ = editor_.scene();
  work_.start([this, scene = given_, models = models_](const BackgroundWork::Progress& progress) {
    std::optional<Placement> placement = placeProbes(scene, models, {}, progress);
    BackgroundWork::Finish finish;
    if (placement) finish = [this, placed = *std::move(placement)] { review(placed); };
    return finish;
  });
  refresh();
}

void PlacePanel::review(Placement placement) {
  if (!alike(editor_.scene(), given_)) {
    emit message(tr("The scene changed meanwhile: place again"));
    return;
  }
  QStringList lines;
  for (const std::string& remark : placement.remarks) lines += QString::fromStdString(remark);
  remarks_->setText(lines.join(". "));
  result_ = std::move(placement);
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const PlacedProbe& placed : result_->probes) {
      auto* item = new QListWidgetItem(QString::fromStdString(placed.probe.name) + ": " +
                                       tr("error %1, %2 % hidden")
                                           .arg(errorText(placed.fit.after.meanDegrees))
                                           .arg(100.0 * placed.fit.hidden, 0, 'f', 0));
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
      item->setCheckState(Qt::Checked);
      item->setToolTip(roomText(*result_, placed));
      list_->addItem(item);
    }
  }
  replace_->setVisible(!given_.probes.empty());
  replace_->setChecked(!given_.probes.empty());
  errors_->setText(tr("%1 rooms, mean error %2")
                       .arg(result_->rooms.size())
                       .arg(errorText(result_->before.meanDegrees) + QString::fromUtf8(" \u2192 ") +
                            errorText(result_->after.meanDegrees)));
  emit ghostsChanged(accepted());
}

std::vector<Probe> PlacePanel::accepted() const {
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < result_->probes.size(); ++i) {
    if (list_->item(static_cast<int>(i))->checkState() == Qt::Checked) probes.push_back(result_->probes[i].probe);
  }
  return probes;
}

void PlacePanel::apply() {
  if (!result_) return;
  const std::vector<Probe> placed = accepted();
  if (placed.empty()) return;
  const bool replace = replace_->isChecked();
  discard();
  std::string first;
  editor_.commit(tr("Place %1 probes").arg(placed.size()), [&](Scene& scene) {
    if (replace) scene.probes.clear();
    first.clear();
    for (Probe probe : placed) {
      probe.name = unusedProbeName(scene, probe.name);
      if (first.empty()) first = probe.name;
      scene.probes.push_back(std::move(probe));
    }
  });
  editor_.selectProbe(findProbe(editor_.scene(), first));
}

void PlacePanel::discard() {
  result_.reset();
  remarks_->clear();
  emit ghostsChanged({});
  refresh();
}

void PlacePanel::update() {
  if (result_ && !alike(editor_.scene(), given_)) discard();
  refresh();
}

void PlacePanel::refresh() {
  place_->setText(running() ? tr("Stop (%1 %)").arg(work_.percent()) : tr("Place probes"));
  place_->setEnabled(running() || !models_.empty());
  const bool placed = result_ && !result_->probes.empty();
  review_->setVisible(placed);
  apply_->setEnabled(placed && !accepted().empty());
  remarks_->setVisible(!remarks_->text().isEmpty());
}

}  // namespace boxprobe
