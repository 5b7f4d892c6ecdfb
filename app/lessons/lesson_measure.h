// The numbers that lessons speak of, measured on what a scene renderer shows. Called by the lesson player and, for
// tasks, by the window; knows no Qt and no lesson file.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"
#include "filters/core/scene/model.h"

namespace boxprobe {

class SceneRenderer;
struct Explanation;

/// What is shown: `renderer` is up to date with `scene`, all work done, its GL context current.
struct ShownScene {
  SceneRenderer& renderer;
  const Scene& scene;
  const std::vector<std::shared_ptr<const Model>>& models;
  Camera camera;                  ///< measured from here; the renderer's own is put back
  int width = 320, height = 200;  ///< pixels of the pictures that are measured
  /// Linear, of that size: measured in place of what the renderer draws. Null: none.
  const ImageRgbaF* picture = nullptr;
  std::function<bool()> goOn = {};  ///< asked while references are integrated; false: they are left incomplete
};

/// Of one picture: every kind but Difference, Counter, Broken and Turned. Nothing where it is not defined there (a
/// pixel that shows the background, a field that does not exist, a number that is not finite).
std::optional<double> measureShown(const ShownScene& shown, const LessonMeasure& measure);

/// Of the pixels that a View or an Explain measure is the mean of.
std::vector<Explanation> explanationsOf(const ShownScene& shown, const LessonMeasure& measure);

/// Root mean square of the differences, tone mapped, within a region.
double pictureDifference(const ImageRgbaF& picture, const ImageRgbaF& other, const PictureRegion& region);

/// "0.31", with three digits that count.
std::string measuredText(double value, const std::string& unit);

/// What the measure is compared with, `times` given if the condition has one.
double conditionLimit(const LessonCondition& condition, double times);
bool conditionHolds(const LessonCondition& condition, double value, double times);

}  // namespace boxprobe
