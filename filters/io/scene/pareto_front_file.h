// Reads the points of an earlier benchmark from its bench.json.
#pragma once

#include <string>
#include <vector>

#include "filters/core/picture/pareto_front.h"

namespace boxprobe {

/// Errors against `reference`, "box" or "scene". Throws InputError with the file and what to do.
std::vector<ParetoPoint> loadParetoFront(const std::string& path, const std::string& reference = "box");

}  // namespace boxprobe
