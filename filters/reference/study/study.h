// Measures techniques in random rooms, point by point and without pictures: averages out the effect of one scene's
// layout, and does not depend on frame size or view. The rooms are exactly their boxes, with other seeds than those
// used to fit constants.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "filters/reference/study/bench_technique.h"
#include "filters/reference/study/study_tally.h"

namespace boxprobe {

struct StudyPlan {
  int rooms = 192;      ///< 0: no study; many, because a few lamps dominate a room's light
  int pointsEach = 16;  ///< per room and roughness
  int faceSize = 128;   ///< texels
  int rays = 4096;      ///< per point, for the integral
  unsigned seed = 77;
};

struct StudyRow {
  std::size_t technique = 0;  ///< in the list that was measured
  study::TechniqueTally tally;
};

struct StudyResult {
  StudyPlan plan;
  std::size_t points = 0;
  std::vector<StudyRow> rows;  ///< without techniques that need more than the box and the map
};

/// If `progress` returns false, the study stops and missing results have no row.
StudyResult runStudy(const StudyPlan& plan, const std::vector<BenchTechnique>& techniques,
                     const std::function<bool(double)>& progress);

}  // namespace boxprobe
