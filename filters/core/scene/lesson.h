// A lesson as plain values: the contents of a *.lesson.json file, with its texts in one language. Tests check its
// claims.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A part of a picture: left, top, right, bottom, as fractions from 0 to 1.
using PictureRegion = std::array<double, 4>;
/// A place in a picture: x, y as fractions from the top left.
using PicturePoint = std::array<double, 2>;

enum class MeasureKind {
  Error,       ///< RMSE from the ray-traced scene, tone mapped by x / (1 + x) and gamma 2.2
  Difference,  ///< the same between the pictures of two steps
  Mean,        ///< mean linear light of the picture, before exposure
  Explain,     ///< a number of a pixel's explanation, as `boxprobe explain --json` names it
  View,        ///< mean of a view of the surfaces, where it is defined
  Bend,        ///< deviation of a line's image in the box from a straight line, relative to its length
  Counter,     ///< work counted since the step before
  Field,       ///< a number of the scene
  Jump,        ///< largest difference between two neighbouring pixels, tone mapped as for Error
  Broken,      ///< fraction of a published form's lookups that are NaN
  Turned,      ///< mean angle between a published form's lookups and the program's, degrees
  Fit          ///< a number of the box fit of the step's probes, as `boxprobe fit --json` names it
};

struct LessonMeasure {
  MeasureKind kind = MeasureKind::Mean;
  /// Index of the step whose picture is measured; nothing: the step that contains the measure.
  std::optional<std::size_t> step;
  std::size_t against = 0;  ///< Difference: the other step
  bool box = false;         ///< Error: against the integral over the box world, which leaves the technique's own error
  PictureRegion region{0.0, 0.0, 1.0, 1.0};
  int channel = -1;                  ///< Mean: 0 to 2; -1: the mean of all three
  std::vector<PicturePoint> points;  ///< Explain: one, or none for the region's mean; Bend: three points on a line
  /// Explain, Fit: JSON pointer; View: its id; Counter: its name; Field: key path as in --set.
  std::string name;
};

enum class Comparison { Above, Below, Within };

/// "measure is above limit", where the limit is a number or a multiple of another measure. Within: the two differ by at
/// most `tolerance`.
struct LessonCondition {
  LessonMeasure measure;
  Comparison comparison = Comparison::Below;
  double limit = 1.0;
  std::optional<LessonMeasure> times;
  double tolerance = 0.0;
};

/// A statement of the lesson, and the condition that checks it.
struct LessonClaim {
  std::string say;   ///< one sentence
  std::string unit;  ///< of the measure
  LessonCondition condition;
};

struct LessonAnswer {
  std::string text;
  bool right = false;
  std::string reply;  ///< why
};

/// Choices, one of which is right.
struct LessonQuestion {
  std::string ask;
  std::vector<LessonAnswer> answers;
};

/// A change to make to the scene, done when the condition holds.
struct LessonTask {
  std::string ask;
  std::string unit;
  LessonCondition done;
  std::string praise;  ///< shown when it is done
  /// Assignments as in `set` that solve it and that do not, for readers who want the answer and for tests.
  std::vector<std::string> solution, mistake;
};

/// A measure over a number of the scene: drawn as the step's picture on sheets and pages.
struct LessonCurve {
  std::string field;           ///< key path as in --set
  std::vector<double> values;  ///< ascending
  LessonMeasure measure;
  std::optional<LessonMeasure> cost;  ///< with an axis of its own
  std::optional<LessonMeasure> line;  ///< one value, of another step, for comparison
  std::string fieldName, measureName, costName, lineName;
};

/// The contents of the first probe, drawn as the step's picture on sheets and pages: either `levels` or `lookups`.
struct LessonMap {
  /// Mip levels of its cubemap, one per column; below each the same level as plain means.
  std::vector<int> levels;
  int face = 0;  ///< the face whose levels are drawn, OpenGL order +X -X +Y -Y +Z -Z
  /// A part of the picture: where in the cubemap its pixels sample, and where they should.
  std::optional<PictureRegion> lookups;
};

/// A small drawing in a corner of the step's picture: the probe's box, the eye, C, and the ray of one pixel.
struct LessonInset {
  PicturePoint at{0.5, 0.5};         ///< the pixel whose ray is drawn
  bool elevation = false;            ///< seen from the side; false: from above
  bool right = true, bottom = true;  ///< the corner in which it is drawn
};

/// A problem to solve on paper. What can be measured of the solution is checked.
struct LessonExercise {
  std::string ask;
  std::string solution;
  std::string formula;  ///< of the solution; empty: none
  std::string unit;     ///< of the measure
  std::optional<LessonCondition> condition;
};

struct LessonStep {
  std::string title;
  std::string say;
  std::string formula;   ///< see formula_mathml.h; empty: none
  std::string formerly;  ///< the lesson that began with this step before it was merged; empty: none
  /// Path of the scene file from which this step starts anew, without the changes before it; empty: it goes on.
  std::string scene;
  std::vector<std::string> assignments;  ///< --set of the command line, on top of the steps before
  std::optional<Camera> camera;          ///< empty: as in the step before
  std::string cameraName;                ///< or a camera of the scene; empty: as in the step before
  std::string view;                      ///< id of a surface view; empty: the picture
  std::string published;           ///< a published form of the projection that draws the picture; empty: the program's
  bool reflections = true;         ///< false: neither probes nor sky
  bool boxes = false;              ///< draws the probes' boxes
  std::vector<PicturePoint> rays;  ///< start points of rays that are drawn
  std::string mayMove;             ///< what to try here; empty: nothing
  std::optional<LessonQuestion> question;
  std::optional<LessonTask> task;
  std::optional<LessonCurve> curve;
  std::optional<LessonMap> map;
  std::optional<LessonInset> inset;
  /// Is the picture drawn from measures or from a probe's contents, instead of being a view of the scene?
  bool drawn() const { return curve.has_value() || map.has_value(); }
};

/// The values of a step's `published`; app/lessons/published_picture.cpp explains each.
inline const std::vector<std::string_view>& publishedForms() {
  static const std::vector<std::string_view> forms = {"behind",  "select", "world", "difference", "half", "rounded",
                                                      "masking", "eta",    "means", "alone",      "fixup"};
  return forms;
}

/// A symbol of the formulas and its meaning.
struct LessonSymbol {
  std::string symbol;  ///< as in a formula
  std::string means;
};

struct Lesson {
  std::string name;             ///< the file's name without its number, as the command line uses it
  std::string path;             ///< of the file
  std::string language = "en";  ///< of the texts below
  std::string unreviewed;       ///< a notice, in that language, that the translation was not reviewed; empty: it was
  std::string title;
  std::string chapter;
  std::string summary;  ///< one sentence for lists
  std::string scene;    ///< path of the scene file
  std::vector<std::string> assignments;
  std::vector<LessonStep> steps;
  std::vector<LessonClaim> claims;
  std::vector<LessonExercise> exercises;
};

}  // namespace boxprobe
