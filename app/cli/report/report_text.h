// The report of `info` for people: the same values as its JSON, a section a kind, a line a thing.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace boxprobe {

/// `report` as sceneReport() makes it.
std::string sceneReportText(const nlohmann::ordered_json& report);

}  // namespace boxprobe
