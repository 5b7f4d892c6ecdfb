// The small figures of data/web/sketches.js: what stands above each in the page of lessons.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct PageSketch {
  const char* name;
  const char* title;
  const char* say;
  bool opens;  ///< stands before the lesson's steps: it answers none of their questions
};

const std::vector<PageSketch>& pageSketches();

/// Null for another name.
const PageSketch* findPageSketch(const std::string& name);

}  // namespace boxprobe
