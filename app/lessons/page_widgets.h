// What stands in the page of lessons beside their steps, named in page.json of their folder. Called by `boxprobe
// lessons -o`; the window has its own ways to show the same.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/lesson.h"

namespace boxprobe {

/// A scene that moves to and fro, as a film that begins again where it ends.
struct LessonLoop {
  struct Field {
    std::string path;                ///< as in --set
    std::vector<double> from, to;    ///< of equal length
    bool list = true;                ///< of numbers; false: one number
    std::string at(double t) const;  ///< the assignment at t, 0 to 1
  };
  std::string name;  ///< of the file, without .webm
  std::string lesson;
  std::vector<std::size_t> steps;   ///< side by side, from 0
  std::vector<std::string> labels;  ///< in the pictures, one a step
  double seconds = 4.0;             ///< to and fro
  bool boxes = false;               ///< drawn, whatever the steps say
  std::string say;                  ///< one or two sentences for whoever cannot see it move
  std::vector<Field> fields;
  std::vector<Camera> walk;  ///< two: the camera goes from one to the other; none: it is the step's
};

/// A text that the lessons speak of.
struct LessonSource {
  std::string title;
  std::string address;  ///< of the web, https
};

/// GLSL that the page compiles and draws with: the function `lookup` of data/web/code.js.
struct LessonCode {
  std::string say;            ///< what is to be done with it
  std::string start, answer;  ///< lines
};

struct PageWidgets {
  std::map<std::string, PicturePoint> plans;  ///< lesson: the place in its pictures whose ray is drawn in plan
  std::vector<std::string> rooms;             ///< lessons that are followed by the room to walk in
  /// Live figure, "infinity" or "stand" of data/web/figures.js, "cone" of cone.js, "fresnel", "lobe" or "glass" of
  /// surface.js, or one of page_sketches.h: its lessons, which have to have a room for the first two. The first opens
  /// the page, the others their lessons.
  std::map<std::string, std::vector<std::string>> figures;
  std::map<std::string, LessonCode> code;  ///< by lesson, which has to have a room
  std::vector<LessonSource> sources;
  std::vector<LessonLoop> loops;
};

/// Empty for a folder without that file. Throws InputError for one that cannot be read.
PageWidgets loadPageWidgets(const std::string& folder);

/// Lessons that it names and that are not there, one sentence each.
std::vector<std::string> unmatchedWidgets(const PageWidgets& widgets, const std::vector<Lesson>& lessons);

}  // namespace boxprobe
