// What placing probes found and decided, as text and as JSON. Called by `boxprobe place`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/session/picture_check.h"
#include "filters/fit/place_probes.h"

namespace boxprobe {

/// `pictures`: null if they were not compared.
nlohmann::ordered_json placeJson(const Placement& placement, const PictureCheck* pictures = nullptr);

/// The same for people: a line for each room and probe, and every decision.
std::string placeText(const Placement& placement, const PictureCheck* pictures = nullptr);

}  // namespace boxprobe
