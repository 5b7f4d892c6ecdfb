// The techniques to measure: every row of the technique tables, and parameter settings that deserve a row of their own.
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
  bool ours = false;  ///< this project's form; false: as published (projection and evaluation both)

  /// For charts and tables: `hdrp`, `raytraced 16 filtered`, `godot power 2`.
  std::string label() const;
  bool sampled() const;  ///< draws random rays, so its error contains noise
  bool operator==(const BenchTechnique& o) const { return id == o.id && parameters == o.parameters; }
};

/// The baselines of errors and costs.
inline constexpr const char* kErrorBaseline = "box+hdrp";
inline constexpr const char* kCostBaseline = "box+none";

/// Every evaluation with the box, every other projection with the plain lookup (and the impostor also with eight
/// footprints), and variants of parameters.
std::vector<BenchTechnique> allBenchTechniques();

/// Parses a list as in --techniques: ids separated by commas, each with all its rows, or with parameters,
/// `raytraced:samples=16:filtered=true`, for that setting. Missing baselines are added. Throws InputError for an
/// unknown id, an unknown parameter or one out of range. An empty list means all.
std::vector<BenchTechnique> chooseBenchTechniques(const std::string& list);

}  // namespace boxprobe
