// The command line of `bench` as values, and the plan they make of a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/render_options.h"
#include "filters/reference/bench/benchmark.h"

namespace boxprobe {

/// --truth without a file: the pictures that come with the source.
inline constexpr const char* kOwnTruth = "own";

struct BenchOptions {
  std::string scenePath;  ///< empty: the scene that comes with the program for this
  std::string folder = "bench";
  bool quick = false;
  std::string techniques;  ///< see chooseBenchTechniques()
  std::string roughnesses;
  std::string cameras;
  std::string materials;
  std::string size;
  std::optional<int> rooms;  ///< of the study; none: as the plan has it
  std::string truthPath;     ///< of the truth pictures' file, or kOwnTruth; empty: a benchmark without them
  int refine = 0;            ///< rays a pixel of refined pictures; 0: none
  bool whole = false;        ///< whole pictures against the path tracer's
  std::uint64_t seed = 1;
  std::vector<std::string> assignments;
  ReportOptions report;
};

void addBenchOptions(CLI::App& command, BenchOptions& options);

/// "low,steep" as two names. Empty: none.
std::vector<std::string> listedNames(const std::string& list);
/// Sorted, each once; none of an empty list. Throws InputError for what is no roughness.
std::vector<double> chosenRoughnesses(const std::string& list);
/// Makes the folder of -o where it is missing. Throws InputError unless `file` can be written into it.
void requireBenchFolder(const std::string& folder, const std::string& file);

/// Width and height of the frames that are timed.
FrameSize timedFrameSize(const BenchOptions& options);

/// Throws InputError for a technique, camera, roughness or size that there is not.
BenchPlan benchPlan(const BenchOptions& options, const Scene& scene);

}  // namespace boxprobe
