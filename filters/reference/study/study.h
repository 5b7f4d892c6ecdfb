// Techniques in rooms made up by chance, point by point and without a picture: what one scene's layout does to a
// technique's error and light averages out over many, and neither a frame's size nor a view of it is in the figures.
// The rooms are exactly their boxes; other seeds than those that constants are fitted in. Called by the benchmark.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "filters/reference/study/bench_technique.h"
#include "filters/reference/study/study_tally.h"

namespace boxprobe {

struct StudyPlan {
  int rooms = 192;      ///< 0: no study; many, since a few lamps decide on a room's light
  int pointsEach = 16;  ///< a room and roughness
  int faceSize = 128;   ///< texels
  int rays = 4096;      ///< a point, of the integral
  unsigned seed = 77;
};

struct StudyRow {
  std::size_t technique = 0;  ///< index into the list it was run with
  study::TechniqueTally tally;
};

struct StudyResult {
  StudyPlan plan;
  std::size_t points = 0;
  std::vector<StudyRow> rows;  ///< without techniques that need more than the box and the map
};

/// `progress` returning false stops it: what is missing then has no row.
StudyResult runStudy(const StudyPlan& plan, const std::vector<BenchTechnique>& techniques,
                     const std::function<bool(double)>& progress);

}  // namespace boxprobe
