// What has to be made for the probes of a scene, and in which order: lazy, so that a probe no visible object uses is
// not captured, and by key, so that nothing is made twice. Owned by the probe set; the work takes its jobs from here.
// Knows maps by their keys alone: neither OpenGL nor VTK.
//
// Jobs in order: the sky; realtime and custom probes (and, during a drag, first bounces) in the order of the scene's
// list; maps read from files; then bounces, all first ones before the second ones.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "filters/vtk/probes/bake_state.h"
#include "filters/vtk/probes/probe_entries.h"
#include "filters/vtk/probes/probe_job.h"
#include "filters/vtk/probes/probe_keys.h"
#include "filters/vtk/probes/probe_sources.h"

namespace boxprobe {

class ProbePlan {
 public:
  /// All must outlive this.
  ProbePlan(const ProbeEntries* entries, const ProbeKeys* keys, const ProbeSources* sources)
      : entries_(entries), keys_(keys), sources_(sources) {}

  // What is to be done at all. Each takes effect with the next make().
  void setEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  /// A handle is held: baked probes are captured for the time being, a single bounce.
  void setInteractive(bool interactive) { interactive_ = interactive; }
  bool interactive() const { return interactive_; }
  /// Names of baked probes that are made whether used or not, and nothing else; empty: whatever is needed.
  void setTargets(std::set<std::string> names) { targets_ = std::move(names); }
  const std::set<std::string>& targets() const { return targets_; }
  /// Key of the sky's own map as it should be. An image is captured finer than a gradient, and no finer than its
  /// columns: a face is a quarter of them. 0: no image.
  void wantSky(std::string key, int imageColumns);
  void skyShows(std::string key) { skyShown_ = std::move(key); }
  const std::string& skyWanted() const { return skyWanted_; }
  bool skyStale() const { return skyWanted_ != skyShown_; }

  /// Plans again from what entries show and want. The memory is to be checked again.
  void make();
  /// In the order in which they are done. A job leaves the list by the plan that is made when its maps are shown.
  const std::vector<ProbeJob>& jobs() const { return jobs_; }
  /// Does the probe show something else than it should, and is something to be done about that now?
  bool stale(std::size_t index) const;
  void giveUp() { jobs_.clear(); }

  /// The job under way; nothing while none is.
  void begin(const ProbeJob& job) { current_ = job; }
  void end() { current_.reset(); }
  const std::optional<ProbeJob>& current() const { return current_; }
  /// May it go on? A map that follows a drag or something that moves is completed, although the scene has moved on: a
  /// picture a little late is better than none.
  bool keepsCurrent() const;
  /// Is anything planned or under way that will be kept? What a drag captures is replaced at its end.
  bool capturesLast() const;

  /// Are there jobs whose memory nobody has checked?
  bool memoryUnchecked() const { return !memoryChecked_ && !jobs_.empty(); }
  /// Do the maps fit into that many bytes? If not, memoryError() says why not.
  bool checkMemory(std::size_t limitBytes);
  /// One line; empty: they fit, or nobody has asked since make().
  const std::string& memoryError() const { return memoryError_; }

  BakeState state(const std::string& probeName) const;
  /// What the maps a baked probe shows were made from; nothing while they are not the final ones. Empty: the sky.
  std::optional<BakeRecord> record(const std::string& probeName) const;

 private:
  void planSky();
  bool bakesAny() const;  ///< of the targets
  void planBounces();
  void planBounce(std::size_t index, int bounce);

  const ProbeEntries* entries_;
  const ProbeKeys* keys_;
  const ProbeSources* sources_;
  bool enabled_ = true, interactive_ = false;
  std::set<std::string> targets_;
  std::string skyWanted_, skyShown_;
  int skyImageColumns_ = 0;

  std::vector<ProbeJob> jobs_;
  std::optional<ProbeJob> current_;
  bool memoryChecked_ = false;  ///< since the jobs were planned
  std::string memoryError_;
};

}  // namespace boxprobe
