// The command line of `bench` as values, and the plan they make of a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/render_options.h"
#include "filters/reference/bench/benchmark.h"

namespace boxprobe {

struct BenchOptions {
  std::string scenePath;  ///< empty: the scene that comes with the program for this
  std::string folder = "bench";
  bool quick = false;
  std::string techniques;  ///< see chooseBenchTechniques()
  std::string roughnesses;
  std::string cameras;
  std::string size;
  std::optional<int> rooms;  ///< of the study; none: as the plan has it
  std::uint64_t seed = 1;
  std::vector<std::string> assignments;
  ReportOptions report;
};

void addBenchOptions(CLI::App& command, BenchOptions& options);

/// Width and height of the frames that are timed.
FrameSize timedFrameSize(const BenchOptions& options);

/// Throws InputError for a technique, camera, roughness or size that there is not.
BenchPlan benchPlan(const BenchOptions& options, const Scene& scene);

}  // namespace boxprobe
