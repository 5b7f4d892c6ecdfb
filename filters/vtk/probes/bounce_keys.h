// Which maps a bounce needs: capture n of a probe shows the probes that light what it sees as they were captured at
// n - 1. The keys follow from that: a bounce whose inputs did not change has the key of the one before, and a probe
// that no bounce of another shows does not make the other stale. Pure bookkeeping; called by the probe set.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filters/io/cube/bake_folder.h"

namespace boxprobe {

class BounceKeys {
 public:
  struct Input {
    std::string view;  ///< of the capture (or import) itself; empty: nobody asks for this probe
    int bounces = 1;
    bool imported = false;              ///< from a picture: the same at every bounce
    bool lattices = false;              ///< of probes light what its later bounces show
    bool realtime = false;              ///< not in other probes' bounces: it would make them stale at every frame
    std::vector<std::size_t> lighting;  ///< probes that light what the capture shows, as boxes are now
    std::optional<BakeRecord> record;   ///< of maps made from the same view before
  };

  BounceKeys() = default;
  explicit BounceKeys(std::vector<Input> inputs);

  const Input& input(std::size_t probe) const { return inputs_[probe]; }
  /// The key of a probe's maps as of a bounce; 1 is the first. More than its own bounces: the last.
  const std::string& key(std::size_t probe, int bounce) const;
  const std::string& finalKey(std::size_t probe) const { return key(probe, inputs_[probe].bounces); }
  /// The probes per probe's later bounces show: as its record has it, so that maps once made are not undone by a box,
  /// plus those that came since.
  const std::vector<std::size_t>& sees(std::size_t probe) const { return sees_[probe]; }
  /// What to remember with maps that are made now.
  BakeRecord record(std::size_t probe) const;

  /// Adds to `missing` what has to be made before and for a probe's maps of a bounce: those of which `have` says no.
  template <typename Have>
  void collect(std::size_t probe, int bounce, const Have& have,
               std::vector<std::pair<int, std::size_t>>& missing) const {
    if (bounce > inputs_[probe].bounces) bounce = inputs_[probe].bounces;
    const std::pair<int, std::size_t> job{bounce, probe};
    if (have(key(probe, bounce))) return;
    // A bounce that shows nothing new is the one before.
    if (bounce > 1 && key(probe, bounce) == key(probe, bounce - 1)) return collect(probe, bounce - 1, have, missing);
    for (const auto& known : missing) {
      if (known == job) return;
    }
    if (bounce > 1) {
      for (const std::size_t other : sees_[probe]) collect(other, bounce - 1, have, missing);
    }
    missing.push_back(job);
  }

 private:
  std::vector<Input> inputs_;
  std::vector<std::vector<std::size_t>> sees_;
  std::vector<std::vector<std::string>> keys_;  ///< [probe][bounce - 1]
};

}  // namespace boxprobe
