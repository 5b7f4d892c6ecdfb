// The points of an earlier benchmark, from its bench.json. Called by whoever shows them; knows no chart.
#pragma once

#include <string>
#include <vector>

#include "filters/core/picture/pareto_front.h"

namespace boxprobe {

/// Against `reference`, "box" or "scene". Throws InputError naming the file and what to do.
std::vector<ParetoPoint> loadParetoFront(const std::string& path, const std::string& reference = "box");

}  // namespace boxprobe
