// What placing probes found and decided, as text and as JSON. Called by `boxprobe place`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "filters/fit/place_probes.h"

namespace boxprobe {

nlohmann::ordered_json placeJson(const Placement& placement);

/// The same for people: a line for each room and probe, and every decision.
std::string placeText(const Placement& placement);

}  // namespace boxprobe
