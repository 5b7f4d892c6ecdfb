// See view_comparison.h.
#include "app/gui/view/view_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/view/picture_difference.h"
#include "app/gui/widgets/table_words.h"
#include "filters/core/base/errors.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

constexpr int kStillMilliseconds = 300;  ///< after the camera has moved or the scene was edited
constexpr int kPollMilliseconds = 30;
const QString kTechnique = "technique:";

QString errorText(const QImage& picture, const QImage& truth) {
  const double psnr = displayPsnr(picture, truth);
  if (std::isinf(psnr)) return ViewComparison::tr("No difference");
  return ViewComparison::tr("Error %1 %, %2 dB")
      .arg(100.0 * pictureDifference(picture, truth).mean, 0, 'f', 1)
      .arg(psnr, 0, 'f', 1);
}

}  // namespace

std::vector<CompareViews::Choice> viewChoices() {
  std::vector<CompareViews::Choice> choices = {
      {"", ViewComparison::tr("Nothing"), {}},
      {"now", ViewComparison::tr("As it is now"), ViewComparison::tr("The scene as it is edited")},
      {"traced", ViewComparison::tr("Path traced"),
       ViewComparison::tr(
           "All light of the scene, path traced in the background, with as many bounces as the probes have. The "
           "others are measured by it")},
      {"before", ViewComparison::tr("Before"), ViewComparison::tr("The scene as it was when the views were opened")},
      {"baked", ViewComparison::tr("All probes baked"),
       ViewComparison::tr("Every realtime probe captured and filtered as a baked one")},
      {"live", ViewComparison::tr("All probes live"),
       ViewComparison::tr("Every baked probe captured as a realtime one")}};
  const auto add = [&choices](const auto& row, const std::string& id) {
    if (const auto technique = parseTechnique(id)) {
      choices.push_back({kTechnique + QString::fromStdString(shortTechniqueId(*technique)), tableWords(row.label),
                         ViewComparison::tr("Every probe by this technique: %1").arg(tableWords(row.help))});
    }
  };
  for (const ProjectionRow& row : projectionRows()) add(row, std::string(row.id));
  for (std::size_t i = 1; i < evaluationRows().size(); ++i) {
    add(evaluationRows()[i], std::string(evaluationRows()[i].id));
  }
  return choices;
}

std::optional<Scene> viewScene(const Scene& now, const Scene& before, const QString& id) {
  if (id == "before") return before;
  Scene scene = now;
  const auto setMode = [&scene](ProbeMode from, ProbeMode to) {
    for (Probe& probe : scene.probes) {
      if (probe.mode == from) probe.mode = to;
    }
    return scene;
  };
  if (id == "baked") return setMode(ProbeMode::Realtime, ProbeMode::Baked);
  if (id == "live") return setMode(ProbeMode::Baked, ProbeMode::Realtime);
  if (!id.startsWith(kTechnique)) return std::nullopt;
  for (Probe& probe : scene.probes) {
    probe.technique = id.mid(kTechnique.size()).toStdString();
    probe.projection = true;
  }
  return scene;
}

ViewComparison::ViewComparison(Document& document, QWidget* picture, Hooks hooks, QObject* parent)
    : QObject(parent), document_(document), views_(new CompareViews(picture, viewChoices())), hooks_(std::move(hooks)) {
  const char* const first[] = {"now", "traced", "technique:infinite", "live"};
  for (int view = 0; view < CompareViews::kViews; ++view) views_->choose(view, first[view]);
  rest_.setSingleShot(true);
  rest_.setInterval(kStillMilliseconds);
  poll_.setSingleShot(true);
  poll_.setInterval(kPollMilliseconds);
  connect(&rest_, &QTimer::timeout, this, &ViewComparison::start);
  connect(&poll_, &QTimer::timeout, this, &ViewComparison::takePicture);
  connect(views_, &CompareViews::chosenAnew, this, [this](int view) {
    views_->show(view, {}, tr("Preparing"));
    views_->showNumbers(view, {});
    wait();
  });
  connect(&trace_, &ReferenceTrace::traced, this, &ViewComparison::traced);
  connect(&trace_, &ReferenceTrace::failed, this, [this](const QString& line) {
    if (!on_ || outdated_) return;  // of a trace that was asked to stop
    emit failed(line);
    setOn(false);
  });
  // After the renderer, which has taken the document's scene by then.
  observer_ = document_.addObserver([this](const Changes& changes) { documentChanged(changes); });
}

ViewComparison::~ViewComparison() {
  document_.removeObserver(observer_);
}

void ViewComparison::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on) {
    before_ = document_.scene();
    for (int view = 0; view < CompareViews::kViews; ++view) views_->show(view, {}, tr("Preparing"));
    views_->setShown(true);
    wait();
    emit message(tr("Four views: choose below each what it shows. Turn the view or edit as before; Esc ends it"));
  } else {
    comeBack();
    trace_.end();
    rest_.stop();
    views_->setShown(false);
    emit message({});
  }
  emit onChanged(on);
}

void ViewComparison::forget() {
  if (shown_) emit ownSceneShown(true);
  shown_.reset();
  setOn(false);
}

bool ViewComparison::sameView() const {
  Camera now = hooks_.camera();
  now.name = camera_.name;
  return now == camera_ && views_->parentWidget()->size() == size_;
}

void ViewComparison::wait() {
  comeBack();
  trace_.requestStop();
  outdated_ = true;
  rest_.start();
}

void ViewComparison::comeBack() {
  poll_.stop();
  left_.clear();
  if (!shown_) return;
  const Changes changes = difference(*shown_, document_.scene());
  shown_.reset();
  hooks_.render(document_.scene(), changes);
  emit ownSceneShown(true);
}

// While the view turns, the picture itself is seen.
void ViewComparison::pictureDrawn() {
  if (!on_ || outdated_ || sameView()) return;
  views_->setShown(false);
  wait();
}

void ViewComparison::pictureChanged() {
  if (!on_) return;
  views_->setShown(false);
  wait();
}

void ViewComparison::documentChanged(const Changes& changes) {
  Changes seen = changes;
  seen.selection = seen.file = seen.cameras = false;
  if (!on_ || !seen.any()) return;
  views_->setShown(false);
  wait();
}

void ViewComparison::start() {
  if (!on_) return;
  if (!hooks_.ready() || document_.previewing()) return rest_.start();
  const QImage now = hooks_.picture();
  if (now.isNull()) return rest_.start();
  outdated_ = false;
  camera_ = hooks_.camera();
  size_ = views_->parentWidget()->size();
  pictures_ = {};
  lights_ = {};
  tracedLight_ = nullptr;
  for (int view = CompareViews::kViews - 1; view >= 0; --view) {
    const QString id = views_->chosen(view);
    views_->showNumbers(view, {});
    views_->show(view, id == "now" ? now : QImage(), id.isEmpty() || id == "now" ? QString() : tr("Preparing"));
    if (id == "now") keep(view, now);
    if (id == "traced") trace_.start(document_.scene(), hooks_.models(), camera_, now.size());
    if (viewScene(document_.scene(), before_, id)) left_.push_back(view);
  }
  views_->setShown(true);
  next();
}

void ViewComparison::next() {
  if (left_.empty()) {
    comeBack();
    return measure();
  }
  view_ = left_.back();
  left_.pop_back();
  Scene wanted = *viewScene(document_.scene(), before_, views_->chosen(view_));
  try {
    validate(wanted);
  } catch (const InputError& error) {
    views_->show(view_, {}, QString::fromUtf8(error.what()));
    return next();
  }
  const Changes changes = difference(shown_ ? *shown_ : document_.scene(), wanted);
  if (!shown_) emit ownSceneShown(false);
  shown_ = std::move(wanted);
  hooks_.render(*shown_, changes);
  poll_.start();
}

void ViewComparison::takePicture() {
  if (!hooks_.ready()) return poll_.start();
  const QImage picture = hooks_.picture();
  keep(view_, picture);
  views_->show(view_, picture, {});
  next();
}

void ViewComparison::keep(int view, const QImage& picture) {
  pictures_[static_cast<std::size_t>(view)] = picture;
  for (int other = 0; other < CompareViews::kViews; ++other) {
    if (views_->chosen(other) != "traced") continue;
    lights_[static_cast<std::size_t>(view)] = hooks_.light(picture.size());
    return;
  }
}

void ViewComparison::traced(const QImage& picture, double share, const std::shared_ptr<const ReferencePicture>& light) {
  if (!on_ || outdated_) return;
  tracedLight_ = light;
  for (int view = 0; view < CompareViews::kViews; ++view) {
    if (views_->chosen(view) != "traced") continue;
    pictures_[static_cast<std::size_t>(view)] = picture;
    views_->show(view, picture, {});
    views_->showNumbers(
        view, share < 1.0 ? tr("%1 % traced").arg(std::lround(100.0 * share)) : tr("The measure of the others"));
  }
  if (!shown_) measure();
}

// By the traced picture where there is one, else by the one in the window.
void ViewComparison::measure() {
  const auto picture = [this](const QString& id) {
    for (int view = 0; view < CompareViews::kViews; ++view) {
      if (views_->chosen(view) == id) return pictures_[static_cast<std::size_t>(view)];
    }
    return QImage();
  };
  const QString by = picture("traced").isNull() ? "now" : "traced";
  const QImage truth = picture(by);
  if (truth.isNull()) return;
  for (int view = 0; view < CompareViews::kViews; ++view) {
    const QImage& each = pictures_[static_cast<std::size_t>(view)];
    const QString id = views_->chosen(view);
    if (each.isNull() || id == "traced" || each.size() != truth.size()) continue;
    if (id == by) {
      views_->showNumbers(view, tr("The measure of the others"));
      continue;
    }
    QString text = errorText(each, truth);
    if (tracedLight_) {
      const auto off = lightDifference(lights_[static_cast<std::size_t>(view)], *tracedLight_);
      if (off) text += "\n" + lightText(*off);
    }
    views_->showNumbers(view, text);
  }
}

}  // namespace boxprobe
