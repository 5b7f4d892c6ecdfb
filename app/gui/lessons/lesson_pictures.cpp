// See lesson_pictures.h.
#include "app/gui/lessons/lesson_pictures.h"

#include <vtkRenderer.h>

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/gui/explain/picture_inset.h"
#include "app/gui/lessons/curve_picture.h"
#include "app/gui/lessons/map_picture.h"
#include "app/gui/lessons/ray_letters.h"
#include "app/lessons/plan_figure.h"
#include "app/web/web_view.h"
#include "filters/core/base/errors.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

LessonPhotographer::LessonPhotographer(int width, int height, std::function<bool()> goOn, bool quiet)
    : width_(width),
      height_(height),
      player_(width, height, std::move(goOn), quiet),
      boxes_(vtkSmartPointer<vtkReflectionProbeRepresentation>::New()) {}

LessonPhotographer::~LessonPhotographer() {
  player_.window()->MakeCurrent();
  boxes_->SetRenderer(nullptr);
}

QImage LessonPhotographer::picture(const LessonStep& step) {
  vtkRenderer* renderer = player_.renderer().renderer();
  boxes_->SetVisibility(step.boxes ? 1 : 0);
  if (step.boxes) {
    const auto& probes = player_.scene().probes;
    boxes_->SetRenderer(renderer);
    // Handles only where there is something to drag.
    const bool drags = !probes.empty() && (step.task || !step.mayMove.empty());
    boxes_->ShowProbes(probes, drags ? std::optional<std::size_t>(0) : std::nullopt, {});
    boxes_->Follow(ViewProjection(renderer->GetActiveCamera(), width_, height_));
  }
  const ImageRgba8 shown = player_.picture();
  QImage picture = QImage(shown.pixels.data(), shown.width, shown.height, QImage::Format_RGBA8888)
                       .convertToFormat(QImage::Format_RGB888);
  // Of one ray: the letters of several would be taken for each other's.
  if (step.rays.size() == 1) {
    const auto x = static_cast<int>(step.rays[0][0] * (width_ - 1)),
               y = static_cast<int>(step.rays[0][1] * (height_ - 1));
    drawRayLetters(picture, player_.renderer().explain(x, y, width_, height_),
                   ViewProjection(renderer->GetActiveCamera(), width_, height_));
  }
  if (step.inset) drawInset(picture, *step.inset, step.rays.size() == 1);
  return picture;
}

void LessonPhotographer::drawInset(QImage& picture, const LessonInset& inset, bool lettered) {
  const QPointF place(inset.at[0] * (width_ - 1), inset.at[1] * (height_ - 1));
  const auto view =
      insetView(player_.renderer().explain(static_cast<int>(place.x()), static_cast<int>(place.y()), width_, height_),
                inset.elevation);
  if (!view) throw WorkError("there is no surface with a probe where an inset's ray starts");
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPictureInset(painter, QRectF(picture.rect()), inset, *view);
  if (!lettered) paintInsetPlace(painter, place);
}

QImage LessonPhotographer::pictureOf(const Lesson& lesson, std::size_t index) {
  const LessonStep& step = lesson.steps[index];
  if (step.map) return mapPicture(*step.map, player_, width_, height_);
  try {
    return picture(step);
  } catch (const WorkError& error) {
    throw WorkError(lesson.path + ": step " + std::to_string(index + 1) + ": " + error.what());
  }
}

void LessonPhotographer::open(const Lesson& lesson) {
  player_.window()->MakeCurrent();
  boxes_->SetRenderer(nullptr);  // drawn over the renderer there was
  player_.open(lesson);
}

LessonPictures LessonPhotographer::take(const Lesson& lesson, const std::optional<PicturePoint>& plan) {
  LessonPictures pictures;
  open(lesson);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const Camera before = i > 0 ? player_.camera() : Camera();
    player_.show(i);
    const LessonStep& step = lesson.steps[i];
    const bool afterDrawn = i > 0 && lesson.steps[i - 1].drawn();
    pictures.sameView.push_back(i > 0 && !step.drawn() && !afterDrawn && step.scene.empty() &&
                                before == player_.camera());
    pictures.curves.emplace_back();
    if (step.curve) pictures.curves.back() = player_.curve(i);
    pictures.steps.push_back(step.curve ? curvePicture(*step.curve, *pictures.curves.back(), width_, height_)
                                        : pictureOf(lesson, i));
    if (i == 0) pictures.firstView = pictures.view = webView(player_.scene(), player_.camera());
    // The room is of the lesson's own scene file.
    if (step.task && pictures.task.empty() && sceneFileOf(lesson, i) == lesson.scene) {
      pictures.task = player_.taskForPage(i);
      if (!pictures.task.empty()) {
        pictures.view = webView(player_.scene(), player_.camera());
        pictures.taskStep = i;
      }
    }
    if (!plan || pictures.plan) continue;
    const int x = std::min(static_cast<int>((*plan)[0] * width_), width_ - 1);
    const int y = std::min(static_cast<int>((*plan)[1] * height_), height_ - 1);
    Explanation explanation = player_.renderer().explain(x, y, width_, height_);
    if (hasPlan(explanation)) pictures.plan = std::move(explanation);
  }
  boxes_->VisibilityOff();
  for (const LessonClaim& claim : lesson.claims) {
    const ClaimResult result = player_.check(claim.condition);
    pictures.claims.push_back({claim.say, claimText(claim.condition, claim.unit, result), result.holds});
  }
  for (const LessonExercise& exercise : lesson.exercises) {
    pictures.exercises.emplace_back();
    if (!exercise.condition) continue;
    const ClaimResult result = player_.check(*exercise.condition);
    pictures.exercises.back() =
        LessonPictures::Claim{exercise.ask, claimText(*exercise.condition, exercise.unit, result), result.holds};
  }
  return pictures;
}

std::string claimText(const LessonCondition& condition, const std::string& unit, const ClaimResult& result) {
  std::string text = measuredText(result.value, unit);
  if (result.divisor) {
    text += " against " + measuredText(*result.divisor, unit);
    if (*result.divisor != 0.0) text += ": " + measuredText(result.value / *result.divisor, "") + " times";
  }
  const std::string limit =
      result.divisor ? measuredText(condition.limit, "") + " times" : measuredText(condition.limit, unit);
  switch (condition.comparison) {
    case Comparison::Above:
      return text + " (more than " + limit + " is claimed)";
    case Comparison::Below:
      return text + " (less than " + limit + " is claimed)";
    case Comparison::Within:
      return text + " (" + limit + " is claimed, within " + measuredText(condition.tolerance, unit) + ")";
  }
  return text;
}

}  // namespace boxprobe
