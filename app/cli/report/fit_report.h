// What a fit found, as text and as JSON. Called by `boxprobe fit`.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/session/fit_light_errors.h"
#include "filters/fit/box/fit_box.h"

namespace boxprobe {

/// Of one probe, as `fit --json` lists it. `before`: as given. `light`: if measured.
nlohmann::ordered_json fitJson(const Probe& before, const BoxFit& fit, const std::optional<FitLightErrors>& light = {});

/// The same for people, with a line for each face whose position counts.
std::string fitText(const Probe& before, const BoxFit& fit, const std::optional<FitLightErrors>& light = {});

}  // namespace boxprobe
