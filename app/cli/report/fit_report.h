// What a fit found, as text and as JSON. Called by `boxprobe fit`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

/// Of one probe, as `fit --json` lists it. `before`: as it was given.
nlohmann::ordered_json fitJson(const Probe& before, const BoxFit& fit);

/// The same for people, with a line for each face whose position counts.
std::string fitText(const Probe& before, const BoxFit& fit);

}  // namespace boxprobe
