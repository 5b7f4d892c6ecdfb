// The keys of the maps that probes should show, worked out from the world they capture (capture_key.h), from each
// other's bounces (bounce_keys.h) and from what maps made before were made of. Called by the plan and by those who make
// maps; knows neither OpenGL nor VTK.
#pragma once

#include <map>
#include <set>
#include <string>

#include "filters/vtk/probes/bounce_keys.h"
#include "filters/vtk/probes/capture_key.h"
#include "filters/vtk/probes/probe_entries.h"
#include "filters/vtk/probes/probe_sources.h"

namespace boxprobe {

class ProbeKeys {
 public:
  /// Both must outlive this.
  ProbeKeys(ProbeEntries* entries, const ProbeSources* sources) : entries_(entries), sources_(sources) {}

  /// What captures show from now on; update() follows.
  void setWorld(CaptureWorld world) { world_ = std::move(world); }
  const CaptureWorld& world() const { return world_; }

  /// Sets what each entry wants, for those that somebody needs: what a probe shows is not even looked for as long as
  /// nobody asks. `targets`: names of probes asked for whether they are used or not.
  void update(const std::set<std::string>& targets);

  /// Of baked and custom probes, as of the last update().
  const BounceKeys& bounces() const { return bounces_; }
  /// Of one face (0 to 5) of a probe's bounce: equal keys, equal texels of level 0. Empty: it is not to be used again.
  std::string face(std::size_t index, int bounce, int face) const;
  /// The same of a realtime probe, given as it was when its capture began, and of its maps made of six such faces.
  std::string realtimeFace(const Probe& probe, int face) const;
  static std::string realtime(const Probe& probe, const FaceKeys& faces);

  /// Its final maps are made: remembers what of, so that moving its box does not undo them.
  void remember(std::size_t index);
  /// What is made for it from here on follows the boxes as they are.
  void forget(std::size_t index) { records_.erase(bounces_.input(index).view); }

 private:
  BounceKeys::Input input(const Probe& probe) const;
  BounceKeys asked(const std::set<std::string>& targets) const;

  ProbeEntries* entries_;
  const ProbeSources* sources_;
  CaptureWorld world_;
  BounceKeys bounces_;
  std::map<std::string, BakeRecord> records_;  ///< by view
};

/// Whether level 0 of a probe's maps holds its faces as they were captured: the frosty filter blurs it, too.
inline bool keepsCapture(const Probe& probe) {
  return probe.filter == FilterKind::Ggx;
}

}  // namespace boxprobe
