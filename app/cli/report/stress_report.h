// What the stress test found, as JSON lines and as tables. Called by the stress command; prints nothing itself.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/stress/stress_run.h"

namespace boxprobe {

/// One class and technique. Errors that were not measured are null; numbers JSON has none for are strings.
nlohmann::ordered_json stressLine(const stress::StressCell& cell, std::uint64_t seed, const std::string& device);

/// What --replay takes: class, technique, numbers.
std::string replayText(const stress::StressCell& cell, std::uint64_t seed);

/// One row per class, all own techniques and terms together.
std::string stressTable(const std::vector<stress::StressCell>& cells, const std::string& device);

/// One row per class, one column a published form: the share of inputs that come out visibly wrong, of the program's
/// own counterpart behind it.
std::string publishedTable(const std::vector<stress::StressCell>& cells);

/// What a single input gives, step by step.
std::string replayReport(const stress::StressClass& inputs, const stress::StressSubject& subject,
                         const stress::StressInput& input);

}  // namespace boxprobe
