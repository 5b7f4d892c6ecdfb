// A lesson as plain values: what a *.lesson.json file holds, with its texts in one language. Read by filters/io, shown
// by the window and by sheets and pages, held to its claims by tests. Knows neither VTK nor Qt nor files.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// A part of a picture: left, top, right, bottom as shares of it, from 0 to 1.
using PictureRegion = std::array<double, 4>;
/// A place in a picture: x, y as shares of it, from the top left.
using PicturePoint = std::array<double, 2>;

enum class MeasureKind {
  Error,       ///< root mean square difference from the ray-traced scene, tone mapped by x / (1 + x) and gamma 2.2
  Difference,  ///< the same between two steps' pictures
  Mean,        ///< mean linear light of the picture, before exposure
  Explain,     ///< a number of a pixel's explanation, as `boxprobe explain --json` names it
  View,        ///< mean of a view of the surfaces, where it is defined
  Bend,     ///< of a straight line of the picture: how far from straight what it shows of the box is, over its length
  Counter,  ///< work counted since the step before
  Field,    ///< a number of the scene
  Jump,     ///< largest difference between two pixels that are neighbours, tone mapped as errors are
  Broken,   ///< share of a published form's lookups that are not a number
  Turned,   ///< mean angle between a published form's lookups and the program's, degrees
  Fit       ///< a number of the box fit of the step's probes, as `boxprobe fit --json` names it
};

struct LessonMeasure {
  MeasureKind kind = MeasureKind::Mean;
  /// Index of the step whose picture it is; nothing: the one it is asked in.
  std::optional<std::size_t> step;
  std::size_t against = 0;  ///< Difference: the other step
  bool box = false;         ///< Error: the truth is the box world, integrated: what is left is the technique's own
  PictureRegion region{0.0, 0.0, 1.0, 1.0};
  int channel = -1;                  ///< Mean: 0 to 2; -1: the mean of all three
  std::vector<PicturePoint> points;  ///< Explain: one, or none for the region's mean; Bend: three that lie on a line
  /// Explain, Fit: JSON pointer; View: its id; Counter: its name; Field: key path as in --set.
  std::string name;
};

enum class Comparison { Above, Below, Within };

/// "measure is above limit", where the limit is a number, or so many times another measure. Within: the two differ by
/// at most `tolerance`.
struct LessonCondition {
  LessonMeasure measure;
  Comparison comparison = Comparison::Below;
  double limit = 1.0;
  std::optional<LessonMeasure> times;
  double tolerance = 0.0;
};

/// Something the lesson says, and how it is held to it.
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

/// Choices, one of them right.
struct LessonQuestion {
  std::string ask;
  std::vector<LessonAnswer> answers;
};

/// Something to do to the scene, done when the condition holds.
struct LessonTask {
  std::string ask;
  std::string unit;
  LessonCondition done;
  std::string praise;  ///< once it is done
  /// What does it, and what does not: assignments as of `set`, for those who want to see the answer, and for tests.
  std::vector<std::string> solution, mistake;
};

/// One measure over a number of the scene: drawn as the step's picture on sheets and pages.
struct LessonCurve {
  std::string field;           ///< key path as in --set
  std::vector<double> values;  ///< rising
  LessonMeasure measure;
  std::optional<LessonMeasure> cost;  ///< against an axis of its own
  std::optional<LessonMeasure> line;  ///< one value, of another step, to compare with
  std::string fieldName, measureName, costName, lineName;
};

/// What the first probe holds, drawn as the step's picture on sheets and pages: one of the two.
struct LessonMap {
  /// Mip levels of its cubemap, a column each; below each the same level made of plain means.
  std::vector<int> levels;
  int face = 0;  ///< whose levels, OpenGL order +X -X +Y -Y +Z -Z
  /// Part of the picture: where in the cubemap its pixels sample, and where they should.
  std::optional<PictureRegion> lookups;
};

/// A small drawing in a corner of the step's picture: the probe's box, the eye, C, and the ray of one of its pixels.
struct LessonInset {
  PicturePoint at{0.5, 0.5};         ///< whose ray
  bool elevation = false;            ///< seen from the side; otherwise from above
  bool right = true, bottom = true;  ///< the corner it stands in
};

/// To be solved on paper. What can be measured of the solution is.
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
  std::string formula;                   ///< see formula_mathml.h; empty: none
  std::vector<std::string> assignments;  ///< --set of the command line, on top of the steps before
  std::optional<Camera> camera;          ///< nothing: as in the step before
  std::string cameraName;                ///< or one of the scene's; empty: as in the step before
  std::string view;                      ///< id of a surface view; empty: the picture
  std::string published;                 ///< the picture as a published form of the projection has it; empty: as it is
  bool reflections = true;               ///< false: neither probes nor sky
  bool boxes = false;                    ///< the probes' boxes are drawn
  std::vector<PicturePoint> rays;        ///< where to start rays that are drawn
  std::string mayMove;                   ///< what to try here; empty: nothing in particular
  std::optional<LessonQuestion> question;
  std::optional<LessonTask> task;
  std::optional<LessonCurve> curve;
  std::optional<LessonMap> map;
  std::optional<LessonInset> inset;
  /// The picture is drawn from measures or from what a probe holds; it is no view of the scene.
  bool drawn() const { return curve.has_value() || map.has_value(); }
};

/// What a step's `published` may be; app/lessons/published_picture.cpp says what each is.
inline const std::vector<std::string_view>& publishedForms() {
  static const std::vector<std::string_view> forms = {"behind",  "select", "world", "difference", "half", "rounded",
                                                      "masking", "eta",    "means", "alone",      "fixup"};
  return forms;
}

/// A symbol of the formulas and the one thing it stands for.
struct LessonSymbol {
  std::string symbol;  ///< as in a formula
  std::string means;
};

struct Lesson {
  std::string name;             ///< what the command line calls it: of the file, without its number
  std::string path;             ///< of the file
  std::string language = "en";  ///< of what a person reads below
  std::string unreviewed;       ///< in that language: nobody has read the translation over; empty: somebody has
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
