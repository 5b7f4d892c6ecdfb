// See place_panel.h.
#include "app/gui/panels/place_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/panels/placed_list.h"
#include "app/gui/view/display_image.h"
#include "app/gui/view/picture_difference.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/window_words.h"
#include "app/session/offscreen_scene.h"
#include "filters/core/base/errors.h"
#include "filters/core/scene/bounces.h"

namespace boxprobe {

namespace {

QString roomsText(std::size_t count) {
  return count == 1 ? PlacePanel::tr("1 room") : PlacePanel::tr("%1 rooms").arg(count);
}

QString errorText(double degrees) {
  return QString::number(degrees, 'f', 2) + QString::fromUtf8("\u00b0");
}

/// What was found and decided of a probe's room, one sentence a line.
QString roomText(const Placement& placement, const PlacedProbe& placed) {
  const PlacedRoom& room = placement.rooms[placed.room];
  const glm::dvec3 size = room.extent.size();
  QStringList lines = {PlacePanel::tr("%1: %2 x %3 x %4")
                           .arg(QString::fromStdString(room.name))
                           .arg(size.x, 0, 'f', 2)
                           .arg(size.y, 0, 'f', 2)
                           .arg(size.z, 0, 'f', 2),
                       PlacePanel::tr("error %1, %2 % hidden")
                           .arg(errorText(placed.fit.after.meanDegrees))
                           .arg(100.0 * placed.fit.hidden, 0, 'f', 0)};
  for (const Phrase& decision : room.decisions) lines += phraseWords(decision);
  for (const Phrase& remark : placed.fit.remarks) lines += phraseWords(remark);
  return lines.join("\n");
}

QString changeText(double before, double after) {
  QString text = QString("%1 \u2192 %2").arg(before, 0, 'f', 3).arg(after, 0, 'f', 3);
  if (before > 0.0) text += PlacePanel::tr(" (%1 %)").arg(qRound(100.0 * (after / before - 1.0)));
  return text;
}

PlacedPictures displayed(const EyePictures& view, const Scene& scene) {
  PlacedPictures shown;
  const auto image = [&](const ImageRgbaF& linear) { return displayImage(linear, scene.exposure, scene.tone); };
  const QImage before = image(view.before), after = image(view.after), truth = image(view.truth);
  shown.images = {before, after, truth, pictureDifference(before, truth).picture,
                  pictureDifference(after, truth).picture};
  return shown;
}

/// In all that rooms and probes follow from: the exposure, say, may be another one.
bool alike(const Scene& a, const Scene& b) {
  return a.models == b.models && a.objects == b.objects && a.materials == b.materials && a.probes == b.probes;
}

}  // namespace

PlacePanel::PlacePanel(Workspace& workspace)
    : workspace_(workspace),
      editor_(workspace.editor()),
      place_(new QPushButton(this)),
      apply_(new QPushButton(tr("Apply"), this)),
      discard_(new QPushButton(tr("Discard"), this)),
      errors_(new QLabel(this)),
      remarks_(helpLabel(this)),
      list_(new PlacedList(this)),
      replace_(new QCheckBox(tr("Replace the probes there are"), this)),
      review_(new QWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Place"));
  place_->setObjectName("placeProbes");
  place_->setToolTip(
      tr("Finds the rooms of the scene, places fitted probes in them, and proposes what makes pictures better by the "
         "path tracer's measure (Ctrl+Shift+F)"));
  form->addRow(place_);
  form->addRow(remarks_);
  form->addRow(review_);

  auto* rows = new QVBoxLayout(review_);
  rows->setContentsMargins(0, 0, 0, 0);
  errors_->setObjectName("placeErrors");
  errors_->setWordWrap(true);
  rows->addWidget(errors_);
  replace_->setObjectName("replaceProbes");
  replace_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  rows->addWidget(replace_);
  auto* buttons = new QHBoxLayout;
  apply_->setObjectName("applyPlaced");
  discard_->setObjectName("discardPlaced");
  buttons->addWidget(apply_);
  buttons->addWidget(discard_);
  rows->addLayout(buttons);  // above the list, which may be long
  list_->setObjectName("placedProbes");
  rows->addWidget(list_);

  connect(place_, &QPushButton::clicked, this, &PlacePanel::place);
  connect(apply_, &QPushButton::clicked, this, &PlacePanel::apply);
  connect(discard_, &QPushButton::clicked, this, &PlacePanel::discard);
  connect(list_, &PlacedList::changed, this, [this] {
    if (result_) emit ghostsChanged(ghosts());
    refresh();
  });
  connect(&work_, &BackgroundWork::progressed, this, &PlacePanel::refresh);
  connect(&work_, &BackgroundWork::ended, this, [this](bool stopped, const QString& error) {
    if (!error.isEmpty()) emit failed(error);
    if (stopped) emit message(tr("Placing was stopped"));
    refresh();
  });
  workspace.listenTo(this);
  connect(workspace.actions().place, &QAction::triggered, this, &PlacePanel::place);
  connect(&workspace, &Workspace::modelsReplaced, this, [this, &workspace] { models_ = workspace.models(); });
  using C = Changes;
  workspace.changes().add(
      "place panel",
      {&C::probeShape, &C::probeTechnique, &C::probeCapture, &C::probeList, &C::materials, &C::objects, &C::models},
      [this](const C&) { update(); });
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
  work_.start([this, scene = given_, models = models_, paths = paths_,
               fit = workspace_.fit()](const BackgroundWork::Progress& progress) {
    constexpr double kPlacing = 0.3;  // of the time, as rooms and pictures usually share it
    BackgroundWork::Finish finish;
    std::optional<Placement> placement =
        placeProbes(scene, models, {}, [&](double done) { return progress(kPlacing * done); });
    if (!placement) return finish;
    Result result{*std::move(placement), {}, {}};
    if (!result.placement.rooms.empty()) {
      LoadedScene loaded;
      loaded.scene = scene;
      loaded.models = models;
      if (fit) loaded.fit = *fit;
      OffscreenSettings settings;
      settings.command = "boxprobe";
      settings.beside = true;
      PictureCheckSettings wanted;
      wanted.views = true;
      wanted.paths = paths;
      try {
        OffscreenScene hidden(settings);
        result.pictures = checkPictures(
            loaded, result.placement, hidden, [&](double done) { return progress(kPlacing + (1.0 - kPlacing) * done); },
            wanted);
        if (!result.pictures) return finish;
        nameProbes(result.placement);
      } catch (const InputError& error) {
        result.notCompared = tr("Pictures were not compared: %1").arg(QString::fromUtf8(error.what()));
      }
    }
    finish = [this, result = std::move(result)] { review(result); };
    return finish;
  });
  refresh();
}

void PlacePanel::review(Result result) {
  if (!alike(editor_.scene(), given_)) {
    emit message(tr("The scene changed meanwhile: place again"));
    return;
  }
  const Placement& placement = result.placement;
  const PictureCheck* pictures = result.pictures ? &*result.pictures : nullptr;
  QStringList lines;
  for (const Phrase& remark : placement.remarks) lines += windowWords(phraseWords(remark));
  if (!result.notCompared.isEmpty()) lines += result.notCompared;
  const bool told = pictures != nullptr && !pictures->sentences.empty();
  if (told && (!pictures->better || pictures->eyes == 0)) {
    lines += phraseWords(pictures->sentences.back());
  }
  remarks_->setText(lines.join(". "));

  std::vector<Proposed> proposed;
  std::vector<PlacedEntry> entries;
  const auto propose = [&](const Probe& probe, bool own, std::size_t index, const QString& reason,
                           const QString& details) {
    PlacedEntry entry;
    entry.name = QString::fromStdString(probe.name);
    entry.reason = reason;
    entry.details = details;
    if (pictures != nullptr && index < pictures->viewOf.size() && pictures->viewOf[index]) {
      const EyePictures& view = pictures->views[*pictures->viewOf[index]];
      const RoomErrors& room = pictures->rooms[view.room];
      entry.gain =
          tr("Error of %1 %2")
              .arg(QString::fromStdString(placement.rooms[view.room].name), changeText(room.before, room.after));
      entry.pictures = displayed(view, given_);
    }
    entries.push_back(std::move(entry));
    proposed.push_back({probe, own});
  };
  for (std::size_t i = 0; i < placement.kept.size(); ++i) {
    const Probe& kept = placement.kept[i];
    const auto before = findProbe(given_, kept.name);
    if (before && given_.probes[*before] == kept) continue;
    propose(kept, true, i,
            kept.bounces == 1  ? tr("As it is, but with 1 bounce of light")
            : allBounces(kept) ? tr("As it is, but with all bounces of light")
                               : tr("As it is, but with %1 bounces of light").arg(kept.bounces),
            {});
  }
  for (std::size_t i = 0; i < placement.probes.size(); ++i) {
    const PlacedProbe& placed = placement.probes[i];
    propose(placed.probe, false, placement.kept.size() + i, phraseWords(placed.reason), roomText(placement, placed));
  }
  list_->show(entries);
  bool allOwn = true;
  for (const Proposed& each : proposed) allOwn = allOwn && each.own;
  replace_->setVisible(!given_.probes.empty() && !allOwn);
  replace_->setChecked(!given_.probes.empty() && !allOwn);
  QStringList tried = {
      tr("Relative error of the light in pictures of the rooms, before and after; mirrors count four "
         "times. 0 is what the path tracer draws")};
  for (std::size_t i = 0; told && i < pictures->sentences.size(); ++i) tried += phraseWords(pictures->sentences[i]);
  errors_->setToolTip(tried.join("\n"));
  if (pictures != nullptr && pictures->eyes > 0 && pictures->before.error > 0.0) {
    errors_->setText(tr("%1. Error of pictures against the path tracer's: %2. Light: %3 of the truth's, before %4")
                         .arg(roomsText(placement.rooms.size()))
                         .arg(changeText(pictures->before.error, pictures->after.error))
                         .arg(pictures->after.light, 0, 'f', 2)
                         .arg(pictures->before.light, 0, 'f', 2));
  } else {
    errors_->setText(tr("%1. Mean error of lookups, pictures not compared: %2 \u2192 %3")
                         .arg(roomsText(placement.rooms.size()))
                         .arg(errorText(placement.before.meanDegrees), errorText(placement.after.meanDegrees)));
  }
  result_ = std::move(proposed);
  emit ghostsChanged(ghosts());
}

std::vector<PlacePanel::Proposed> PlacePanel::accepted() const {
  std::vector<Proposed> probes;
  for (std::size_t i = 0; i < result_->size(); ++i) {
    if (list_->ticked(i)) probes.push_back((*result_)[i]);
  }
  return probes;
}

std::vector<Probe> PlacePanel::ghosts() const {
  std::vector<Probe> probes;
  for (const Proposed& each : accepted()) probes.push_back(each.probe);
  return probes;
}

void PlacePanel::apply() {
  if (!result_) return;
  const std::vector<Proposed> placed = accepted();
  if (placed.empty()) return;
  const bool replace = replace_->isChecked();
  discard();
  std::string first;
  editor_.commit(placed.size() == 1 ? tr("Place 1 probe") : tr("Place %1 probes").arg(placed.size()),
                 [&](Scene& scene) {
                   if (replace) scene.probes.clear();
                   first.clear();
                   for (const Proposed& each : placed) {
                     Probe probe = each.probe;
                     const auto own = each.own ? findProbe(scene, probe.name) : std::nullopt;
                     if (!own) probe.name = unusedProbeName(scene, probe.name);
                     if (first.empty()) first = probe.name;
                     if (own) {
                       scene.probes[*own] = std::move(probe);
                     } else {
                       scene.probes.push_back(std::move(probe));
                     }
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
  const bool placed = result_ && !result_->empty();
  review_->setVisible(placed);
  apply_->setEnabled(placed && !accepted().empty());
  remarks_->setVisible(!remarks_->text().isEmpty());
}

}  // namespace boxprobe
