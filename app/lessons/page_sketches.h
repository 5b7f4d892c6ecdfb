// The small figures of the page of lessons, and what stands above each.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct PageSketch {
  enum Kind { Plan, Surface, Cone };  ///< of data/web/sketches.js and sketches_more.js, of surface.js, of cone.js
  Kind kind;
  const char* name;
  const char* title;
  const char* say;
  bool opens;  ///< stands before the lesson's steps: it answers none of their questions
};

const std::vector<PageSketch>& pageSketches();

/// Null for another name.
const PageSketch* findPageSketch(const std::string& name);

}  // namespace boxprobe
