// See lesson_player.h.
#include "app/lessons/lesson_player.h"

#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <utility>

#include "app/lessons/published_picture.h"
#include "app/lessons/room_task.h"
#include "app/session/load_scene.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/rays/ray_sources.h"

namespace boxprobe {

namespace {

constexpr int kPictureSamples = 4;
constexpr int kMeasuredWidth = 320;  // measures are of smaller pictures than those to be looked at

/// What lessons may count.
std::optional<double> counter(const Counters& counters, const std::string& name) {
  const std::pair<const char*, std::uint64_t Counters::*> known[] = {{"facesCaptured", &Counters::facesCaptured},
                                                                     {"skyFacesCaptured", &Counters::skyFacesCaptured},
                                                                     {"levelsFiltered", &Counters::levelsFiltered},
                                                                     {"programsCompiled", &Counters::programsCompiled}};
  for (const auto& [id, member] : known) {
    if (name == id) return static_cast<double>(counters.*member);
  }
  return std::nullopt;
}

constexpr const char* kStopped = "interrupted: stopped before the work was done";

std::unique_ptr<RayLayer> makeRayLayer(SceneRenderer& renderer) {
  auto layer = std::make_unique<RayLayer>(renderer.renderer());
  layer->setLegendVisible(false);
  layer->setLineWidth(2.5);
  return layer;
}

}  // namespace

LessonPlayer::LessonPlayer(int width, int height, std::function<bool()> goOn, bool quiet)
    : width_(width),
      height_(height),
      goOn_(std::move(goOn)),
      offscreen_({"boxprobe lessons", width, height, kPictureSamples, quiet}),
      rays_(makeRayLayer(offscreen_.renderer())),
      rayFilter_(vtkSmartPointer<vtkProjectionRays>::New()) {
  rayFilter_->SetKindEnabled(RayKind::TrueHit, false);
  rayFilter_->SetKindEnabled(RayKind::Error, false);
}

LessonPlayer::~LessonPlayer() {
  window()->MakeCurrent();
}

// What lessons before have captured would be found again: work would not be counted, and what a capture's second bounce
// shows is kept while boxes and techniques change.
void LessonPlayer::forgetCaptures() {
  window()->MakeCurrent();
  rays_.reset();
  offscreen_.forget();
  rays_ = makeRayLayer(renderer());
}

void LessonPlayer::open(const Lesson& lesson) {
  if (lesson_ != nullptr) forgetCaptures();
  lesson_ = &lesson;
  shown_.reset();
  work_.clear();
  pictures_.clear();
  lookups_.clear();
  errors_.clear();
}

void LessonPlayer::showScene(std::size_t step, Scene scene) {
  const Counters before = renderer().counters();
  if (scene.models != modelFiles_) {
    models_ = loadModels(scene);
    modelFiles_ = scene.models;
  }
  scene_ = std::move(scene);
  camera_ = lessonCamera(*lesson_, step, scene_);
  const LessonStep& content = lesson_->steps[step];
  ShownSettings settings{camera_, content.reflections};
  if (!content.view.empty()) settings.view.view = findSurfaceView(content.view).value_or(0);
  offscreen_.show(scene_, models_, settings);
  if (!offscreen_.capture([this](double) { return !goOn_ || goOn_(); })) throw WorkError(kStopped);
  offscreen_.requireHealthy();
  const Counters& after = renderer().counters();
  Counters done;
  done.facesCaptured = after.facesCaptured - before.facesCaptured;
  done.skyFacesCaptured = after.skyFacesCaptured - before.skyFacesCaptured;
  done.levelsFiltered = after.levelsFiltered - before.levelsFiltered;
  done.programsCompiled = after.programsCompiled - before.programsCompiled;
  work_.emplace(step, done);
}

void LessonPlayer::show(std::size_t step) {
  if (shown_ == step) return;
  rays_->setVisible(false);
  showScene(step, lessonScene(*lesson_, step));
  shown_ = step;
}

void LessonPlayer::showChanged(std::size_t step, const std::vector<std::string>& changes) {
  Scene scene = lessonScene(*lesson_, step);
  setSceneFields(scene, changes);
  rays_->setVisible(false);
  showScene(step, std::move(scene));
  shown_.reset();
}

void LessonPlayer::drawRays(const LessonStep& step) {
  rays_->setVisible(false);
  if (step.rays.empty()) return;
  RaySources sources(models_, scene_);
  const PixelRays pixels(renderer().renderer()->GetActiveCamera(), width_, height_);
  std::vector<RaySample> samples;
  for (const PicturePoint& point : step.rays) {
    if (auto sample = sources.under(pixels.through(point[0] * width_, point[1] * height_))) samples.push_back(*sample);
  }
  rayFilter_->SetProbes(scene_.probes);
  rayFilter_->SetEye(camera_.position.x, camera_.position.y, camera_.position.z);
  rayFilter_->SetInputData(rayPoints(samples));
  rayFilter_->Update();
  rays_->setRays(rayFilter_->GetOutput());
  rays_->setVisible(true);
}

ImageRgba8 LessonPlayer::picture() {
  if (shown_ && !lesson_->steps[*shown_].published.empty()) {
    constexpr int kScale = 2;  // drawn on the CPU, pixel by pixel
    PublishedPicture published(renderer(), scene_, lesson_->steps[*shown_].published, width_ / kScale,
                               height_ / kScale);
    while (published.draw(height_)) {
    }
    return published.display(kScale);
  }
  if (shown_) drawRays(lesson_->steps[*shown_]);
  return renderer().renderDisplay();
}

const ImageRgbaF& LessonPlayer::linear(std::size_t step) {
  const auto kept = pictures_.find(step);
  if (kept != pictures_.end()) return kept->second;
  show(step);
  const int height = kMeasuredWidth * height_ / width_;
  const std::string& form = lesson_->steps[step].published;
  if (!form.empty()) {
    PublishedPicture published(renderer(), scene_, form, kMeasuredWidth, height);
    while (published.draw(height)) {
    }
    lookups_[step] = {published.brokenShare(), published.meanTurn()};
    return pictures_[step] = published.linear();
  }
  const SurfaceViewSettings view = renderer().view();
  renderer().setView({});
  pictures_[step] = renderer().renderLinear(kMeasuredWidth, height, kPictureSamples);
  renderer().setView(view);
  return pictures_[step];
}

double LessonPlayer::measure(const LessonMeasure& measure, std::optional<std::size_t> here) {
  std::optional<double> value;
  const std::size_t step = measure.step.value_or(here.value_or(0));
  if (measure.kind == MeasureKind::Difference) {
    const ImageRgbaF& picture = linear(step);
    value = pictureDifference(picture, linear(measure.against), measure.region);
  } else if (measure.kind == MeasureKind::Broken || measure.kind == MeasureKind::Turned) {
    linear(step);
    const auto found = lookups_.find(step);
    if (found != lookups_.end()) {
      value = measure.kind == MeasureKind::Broken ? found->second.broken : found->second.turned;
    }
  } else {
    if (measure.step) show(*measure.step);
    if (measure.kind == MeasureKind::Counter) {
      value = counter(work_[step], measure.name);
    } else {
      rays_->setVisible(false);
      window()->MakeCurrent();
      const bool published = measure.step && !lesson_->steps[step].published.empty();
      ShownScene shown = shownScene();
      if (published) shown.picture = &linear(step);
      const bool kept = measure.step && measure.kind == MeasureKind::Error;
      const auto known = errors_.find({step, measure.box, measure.region});
      value = kept && known != errors_.end() ? known->second : measureShown(shown, measure);
      if (goOn_ && !goOn_()) throw WorkError(kStopped);
      if (kept && value) errors_[{step, measure.box, measure.region}] = *value;
    }
  }
  if (!value) throw WorkError(lesson_->path + ": a measure is not defined where the lesson asks for it");
  return *value;
}

ShownScene LessonPlayer::shownScene() {
  ShownScene shown{renderer(), scene_, models_, camera_, kMeasuredWidth, kMeasuredWidth * height_ / width_};
  shown.goOn = goOn_;
  return shown;
}

std::string LessonPlayer::taskForPage(std::size_t step) {
  const auto& task = lesson_->steps[step].task;
  if (!task) return {};
  show(step);
  double start = 0.0;
  done(*task, step, &start);
  return roomTask(shownScene(), *task, start);
}

ClaimResult LessonPlayer::check(const LessonCondition& condition) {
  ClaimResult result;
  result.value = measure(condition.measure, std::nullopt);
  if (condition.times) result.divisor = measure(*condition.times, std::nullopt);
  result.limit = conditionLimit(condition, result.divisor.value_or(1.0));
  result.holds = conditionHolds(condition, result.value, result.divisor.value_or(1.0));
  return result;
}

CurvePoints LessonPlayer::curve(std::size_t step) {
  const LessonCurve& curve = lesson_->steps[step].curve.value();
  CurvePoints points;
  for (const double value : curve.values) {
    showChanged(step, {curve.field + "=" + numberText(value)});
    points.measured.push_back(measure(curve.measure, step));
    if (curve.cost) points.costs.push_back(measure(*curve.cost, step));
  }
  if (curve.line) points.line = measure(*curve.line, step);
  return points;
}

bool LessonPlayer::done(const LessonTask& task, std::size_t step, double* value) {
  const double measured = measure(task.done.measure, step);
  if (value != nullptr) *value = measured;
  const double times = task.done.times ? measure(*task.done.times, step) : 1.0;
  return conditionHolds(task.done, measured, times);
}

}  // namespace boxprobe
