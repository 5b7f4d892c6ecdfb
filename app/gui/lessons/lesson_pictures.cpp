// See lesson_pictures.h.
#include "app/gui/lessons/lesson_pictures.h"

#include <vtkRenderer.h>

#include <utility>

#include "app/gui/handles/probe_overlay.h"

namespace boxprobe {

LessonPhotographer::LessonPhotographer(int width, int height, std::function<bool()> goOn, bool quiet)
    : width_(width), height_(height), player_(width, height, std::move(goOn), quiet) {}

LessonPhotographer::~LessonPhotographer() {
  player_.window()->MakeCurrent();
  boxes_.reset();
}

QImage LessonPhotographer::picture(const LessonStep& step) {
  vtkRenderer* renderer = player_.renderer().renderer();
  if (step.boxes && !boxes_) boxes_ = std::make_unique<ProbeOverlay>(player_.window(), renderer);
  if (boxes_) {
    const auto& probes = player_.scene().probes;
    boxes_->setVisible(step.boxes);
    boxes_->update(probes, probes.empty() ? std::nullopt : std::optional<std::size_t>(0), std::nullopt);
    boxes_->follow(ViewProjection(renderer->GetActiveCamera(), width_, height_));
  }
  const ImageRgba8 shown = player_.picture();
  return QImage(shown.pixels.data(), shown.width, shown.height, QImage::Format_RGBA8888)
      .convertToFormat(QImage::Format_RGB888);
}

LessonPictures LessonPhotographer::take(const Lesson& lesson) {
  LessonPictures pictures;
  player_.window()->MakeCurrent();
  boxes_.reset();  // drawn over the renderer there was
  player_.open(lesson);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    player_.show(i);
    pictures.steps.push_back(picture(lesson.steps[i]));
  }
  if (boxes_) boxes_->setVisible(false);
  for (const LessonClaim& claim : lesson.claims) {
    const ClaimResult result = player_.check(claim.condition);
    pictures.claims.push_back({claim.say, claimText(claim, result), result.holds});
  }
  return pictures;
}

std::string claimText(const LessonClaim& claim, const ClaimResult& result) {
  const LessonCondition& condition = claim.condition;
  std::string text = measuredText(result.value, claim.unit);
  if (result.divisor) {
    text += " against " + measuredText(*result.divisor, claim.unit);
    if (*result.divisor != 0.0) text += ": " + measuredText(result.value / *result.divisor, "") + " times";
  }
  const std::string limit =
      result.divisor ? measuredText(condition.limit, "") + " times" : measuredText(condition.limit, claim.unit);
  switch (condition.comparison) {
    case Comparison::Above:
      return text + " (more than " + limit + " is claimed)";
    case Comparison::Below:
      return text + " (less than " + limit + " is claimed)";
    case Comparison::Within:
      return text + " (" + limit + " is claimed, within " + measuredText(condition.tolerance, claim.unit) + ")";
  }
  return text;
}

}  // namespace boxprobe
