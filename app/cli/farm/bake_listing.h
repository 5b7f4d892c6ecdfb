// What of a scene's baked probes lies in their folder: `bake --list` and `--check`. Reads files, captures nothing.
#pragma once

#include <string>
#include <vector>

#include "app/session/offscreen_scene.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"

namespace boxprobe {

struct BakeRow {
  std::string name;
  std::string key;    ///< of the final maps
  std::string state;  ///< "done"; "stale": a file of its name shows something else; "missing"
  int made = 0;       ///< bounces whose maps are there, of
  int bounces = 1;
  double seconds = 0.0;  ///< to make it from nothing, see bakeSeconds()
};

/// Some of what was asked for is not there. Exit status 3.
class WorkLeft : public Error {
 public:
  using Error::Error;
  int exitStatus() const override { return 3; }
};

/// Of these probes, in this order; `shown` has them as bake targets. Each file is read whole, for its checksum.
std::vector<BakeRow> bakeRows(const OffscreenScene& shown, const std::vector<Probe>& probes, const BakeFolder& folder);

/// A line each, and a sum; or JSON, a line each. `lattices`: later bounces are lit by them (not with lamps in the map).
std::string bakeListText(const std::vector<BakeRow>& rows, const std::vector<Probe>& probes, const std::string& folder,
                         bool lattices);
std::string bakeListJson(const std::vector<BakeRow>& rows);

/// Throws WorkLeft naming what is not done up to `bounce` (0: all).
void requireBaked(const std::vector<BakeRow>& rows, int bounce, const std::string& folder);

}  // namespace boxprobe
