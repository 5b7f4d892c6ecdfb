// Runs lessons without a window: shows a step, takes its picture, holds the lesson to its claims. Called by
// `boxprobe lessons` and by tests; knows no Qt. Needs a display (see offscreen_scene.h).
#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "app/lessons/lesson_measure.h"
#include "app/session/offscreen_scene.h"
#include "filters/core/base/counters.h"
#include "filters/core/scene/lesson.h"
#include "filters/vtk/rays/ray_layer.h"
#include "filters/vtk/rays/vtkProjectionRays.h"

namespace boxprobe {

struct ClaimResult {
  double value = 0.0;
  double limit = 0.0;             ///< what it is compared with
  std::optional<double> divisor;  ///< the measure that the limit is a multiple of
  bool holds = false;
};

/// What a step's curve is drawn from.
struct CurvePoints {
  std::vector<double> measured;  ///< one for each value of the curve
  std::vector<double> costs;     ///< as many; empty: it has none
  std::optional<double> line;
};

class LessonPlayer {
 public:
  /// `goOn` is asked between units of work; false ends what runs with a WorkError. `quiet`: without VTK's warnings.
  LessonPlayer(int width, int height, std::function<bool()> goOn = {}, bool quiet = false);
  ~LessonPlayer();
  LessonPlayer(const LessonPlayer&) = delete;
  LessonPlayer& operator=(const LessonPlayer&) = delete;

  /// The lesson must outlive its use here. Nothing of the lesson before is kept but programs and models.
  void open(const Lesson& lesson);
  /// All captured, ready to be drawn. What is drawn over it beyond rays is the caller's.
  void show(std::size_t step);
  /// With `changes` to the step's scene: what a learner may do.
  void showChanged(std::size_t step, const std::vector<std::string>& changes);
  const Scene& scene() const { return scene_; }
  Camera camera() const { return camera_; }
  SceneRenderer& renderer() { return offscreen_.renderer(); }
  vtkOpenGLRenderWindow* window() { return offscreen_.window(); }

  /// The step that is shown, as the window shows it, rays included.
  ImageRgba8 picture();

  /// Shows what steps it needs. Throws WorkError for a measure that is not defined.
  ClaimResult check(const LessonCondition& condition);
  /// Of the step, which must have a curve. Shows each of its values. Throws WorkError as check does.
  CurvePoints curve(std::size_t step);
  /// Of what is shown now, `step` of the lesson being meant where a measure names none.
  bool done(const LessonTask& task, std::size_t step, double* value = nullptr);
  /// Of a step's task, what lets a browser measure it (see roomTask); empty: it cannot. Shows the step.
  std::string taskForPage(std::size_t step);

 private:
  /// Of a published form, see PublishedPicture.
  struct Lookups {
    double broken = 0.0, turned = 0.0;
  };

  double measure(const LessonMeasure& measure, std::optional<std::size_t> here);
  const ImageRgbaF& linear(std::size_t step);
  ShownScene shownScene();
  void drawRays(const LessonStep& step);
  void showScene(std::size_t step, Scene scene);
  void forgetCaptures();

  int width_, height_;
  std::function<bool()> goOn_;
  OffscreenScene offscreen_;
  std::unique_ptr<RayLayer> rays_;
  vtkSmartPointer<vtkProjectionRays> rayFilter_;
  const Lesson* lesson_ = nullptr;
  std::vector<ModelFile> modelFiles_;
  std::vector<std::shared_ptr<const Model>> models_;
  std::optional<std::size_t> shown_;  ///< nothing: not a step as the lesson has it
  Scene scene_;
  Camera camera_;
  std::map<std::size_t, Counters> work_;        ///< of each step, when it was first shown
  std::map<std::size_t, ImageRgbaF> pictures_;  ///< linear, for differences and published forms
  std::map<std::size_t, Lookups> lookups_;      ///< of the latter
  /// Step, against the box world?, region: claims of a lesson compare several steps with the same one.
  std::map<std::tuple<std::size_t, bool, PictureRegion>, double> errors_;
};

}  // namespace boxprobe
