// Scenes whose every number is legal and whose transforms go to the ends of what numbers may be: put together, fitted,
// given probes and ray traced. What fails ends the process or makes a number that is none. Called by `stress`.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace boxprobe {

constexpr const char* kExtremeScenes = "extreme-scenes";

struct ExtremeScenesResult {
  std::uint64_t count = 0;
  std::uint64_t refused = 0;    ///< by a message, as a file would be
  std::uint64_t nonFinite = 0;  ///< with a box, an origin or a pixel that is no number
  std::string worst;            ///< of the first of those: its number, and what was no number
};

/// Scenes `first` to `first + count - 1` of a seed; each depends on its number and the seed alone. `progress` is called
/// after each and returns false to stop.
ExtremeScenesResult runExtremeScenes(std::uint64_t first, std::uint64_t count, std::uint64_t seed,
                                     const std::function<bool(double)>& progress);

/// As a line beside those of the other classes, and as a row of the table.
nlohmann::ordered_json extremeScenesLine(const ExtremeScenesResult& result, std::uint64_t seed);
std::string extremeScenesText(const ExtremeScenesResult& result);

}  // namespace boxprobe
