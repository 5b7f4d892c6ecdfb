// What becomes of finished maps: they are shown, remembered with what they were made of, and kept for undo. Called by
// the work when a job is done; plans nothing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/bake_items.h"
#include "filters/vtk/probes/probe_light.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/probe_programs.h"
#include "filters/vtk/probes/shown_probes.h"

namespace boxprobe {

class ProbePublisher {
 public:
  /// All pointers must outlive this.
  ProbePublisher(std::shared_ptr<DrawState> state, ProbeEntries* entries, ProbeKeys* keys, ProbePlan* plan,
                 MapCache* cache, ShownProbes* shown, ProbeLight* light, ProbePrograms* programs)
      : state_(std::move(state)),
        entries_(entries),
        keys_(keys),
        plan_(plan),
        cache_(cache),
        shown_(shown),
        light_(light),
        programs_(programs) {}

  /// The next plan counts with them.
  void publish(MadeMaps made);
  /// Shows maps made before wherever a probe, or the sky, wants them.
  void showCached();
  /// Maps of earlier bounces are held until now, because later ones are made from them.
  void dropEarlierBounces() { earlier_.clear(); }

 private:
  void publishSky(MadeMaps made);
  void publishDrag(MadeMaps made);
  void publishRealtime(MadeMaps made);
  void publishFinal(MadeMaps made);
  void show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  void showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  std::shared_ptr<DrawState> state_;
  ProbeEntries* entries_;
  ProbeKeys* keys_;
  ProbePlan* plan_;
  MapCache* cache_;
  ShownProbes* shown_;
  ProbeLight* light_;
  ProbePrograms* programs_;
  std::vector<std::shared_ptr<const ProbeMaps>> earlier_;
};

}  // namespace boxprobe
