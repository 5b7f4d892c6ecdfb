// What the benchmark measures: every row of the technique tables, and the settings of its parameters that are worth a
// row of their own. Called by the benchmark and its command; knows no technique by name but the baselines.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

struct BenchTechnique {
  std::string id;                                    ///< full id, `box+none`
  std::map<std::string, ParameterValue> parameters;  ///< those that differ from their defaults
  bool ours = false;  ///< this project's own form; false: as published (projection and evaluation both)

  /// For charts and tables: `hdrp`, `raytraced 16 filtered`, `godot power 2`.
  std::string label() const;
  bool sampled() const;  ///< draws rays at random: its error has noise in it
  bool operator==(const BenchTechnique& o) const { return id == o.id && parameters == o.parameters; }
};

/// What errors and costs are divided by.
inline constexpr const char* kErrorBaseline = "box+hdrp";
inline constexpr const char* kCostBaseline = "box+none";

/// Every evaluation behind the box, every other projection with the plain lookup (and the impostor also with eight
/// footprints), and variants in the parameters that a technique reads.
std::vector<BenchTechnique> allBenchTechniques();

/// Of a list as --techniques takes it: ids separated by commas, each alone for all its rows, or with parameters,
/// `raytraced:samples=16:filtered=true`, for that one setting. The baselines are added where they are missing. Throws
/// InputError for an unknown id, an unknown parameter or one out of range. An empty list: all.
std::vector<BenchTechnique> chooseBenchTechniques(const std::string& list);

}  // namespace boxprobe
