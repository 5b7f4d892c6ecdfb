// A task that the page of lessons can measure by itself: the rays that the measure is the mean of, so that a browser
// needs nothing but the box and the capture origin. Called by the lesson photographer; data/web/task.js reads it.
#pragma once

#include <string>

#include "app/lessons/lesson_measure.h"

namespace boxprobe {

/// JSON; empty for a measure that needs more than the first probe's box and origin. Known are the views hit-error and
/// direction-error, and slabFactors of a pixel's first probe. `start`: what is measured before anything is done.
/// {"done": "below", "limit", "tolerance", "unit", "praise", "start", "measure": M, "times": M}, M being {"kind":
/// "hit-error" | "direction-error" | "slab", "axis", "rays": [P, R, true distance, seven numbers each]}: P and R along
/// the box's axes, P from the world's origin, scene units.
std::string roomTask(const ShownScene& shown, const LessonTask& task, double start);

}  // namespace boxprobe
