// What the baseline runs: the program's own commands, one a row.
#pragma once

#include <string>
#include <vector>

namespace boxprobe::test {

struct BaselineRun {
  std::string name;     ///< of its entry in baseline.json
  std::string command;  ///< arguments between spaces; the second is a scene: of the baseline, or of data/scenes
  std::string output;   ///< what stands behind -o, or empty: the results on stdout are compared
  bool drawn = false;   ///< its numbers depend on pictures
};

/// The quickest first.
const std::vector<BaselineRun>& baselineRuns();

}  // namespace boxprobe::test
