// Plan and side elevation of one pixel's projection, as in a textbook: box, capture origin, ray, hit. Geometry only, in
// scene units along the box's axes relative to the capture origin; the window paints it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filters/explain/explanation.h"

namespace boxprobe {

enum class SchematicLine { Eye, Normal, Reflected, Lookup, TrueHit, Slab };
enum class SchematicPoint { Eye, Shading, Hit, Origin, TrueHit, SlabPlane };

/// One of the two drawings. Points are (right, up) on the paper, in scene units.
struct SchematicView {
  Phrase title;               ///< "Plan (from above)"
  int right = 0, up = 1;      ///< the box axis of each direction of the paper
  bool rightFlipped = false;  ///< towards the negative axis
  bool upFlipped = false;
  glm::dvec2 low{0.0}, high{0.0};  ///< extent to show: box, P, C, H
  std::optional<glm::dvec2> boxLow, boxHigh;
  bool boxUsed = true;  ///< false: the technique does not use it

  struct Line {
    SchematicLine kind;
    glm::dvec2 from, to;
    std::string label;            ///< shown beside the line; may be empty
    double foreshortening = 1.0;  ///< length on the paper over length in space
  };
  struct Point {
    SchematicPoint kind;
    glm::dvec2 at;
    Phrase label;                         ///< a word, or letters
    glm::dvec2 labelDirection{0.0, 1.0};  ///< unit: away from the lines at the point
  };
  /// A plane of the box seen edge-on, where the extended ray crosses it.
  struct Plane {
    glm::dvec2 from, to;
    glm::dvec2 crossing;
    std::string label;      ///< "t_x = 2.12"
    bool smallest = false;  ///< the decisive plane
  };
  std::vector<Line> lines;
  std::vector<Point> points;
  std::vector<Plane> planes;
};

struct Schematic {
  SchematicView plan;       ///< from above: x to the right, z towards the reader
  SchematicView elevation;  ///< from the side with the least foreshortening of the ray, y upwards
  Phrase caption;           ///< "d = min(t_x, t_y, t_z) = 2.12", or why there is none
};

/// Nothing without a surface, a normal or a probe to draw.
std::optional<Schematic> schematic(const Explanation& e);

/// The same ray in one small drawing for the corner of a picture: box, eye, P, C, the ray and what is sampled, without
/// normals or distances. For a technique without a hit it draws the ray to the surface it meets, and R again from C.
/// From above, or in elevation. Nothing if schematic() returns nothing.
std::optional<SchematicView> insetView(const Explanation& e, bool elevation);

}  // namespace boxprobe
