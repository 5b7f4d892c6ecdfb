// From a planned job to what the bake runner makes: what each face shows, which faces are kept, what the scene is lit
// by meanwhile. Called when a job begins; neither runs it nor shows what comes of it.
#pragma once

#include <functional>
#include <memory>

#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/level_needs.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

/// The maps of a job, with all that is known of them.
struct MadeMaps {
  ProbeJob job;    ///< with its key, which a realtime probe's is given by its faces
  FaceKeys faces;  ///< empty texts: faces that are not to be used again
  std::shared_ptr<const ProbeMaps> maps;
  bool fromFile = false;
};

class ProbeItems {
 public:
  using Publish = std::function<void(MadeMaps made)>;

  /// All pointers must outlive this and the items it makes.
  ProbeItems(SceneContent* content, const ProbeEntries* entries, const ProbeKeys* keys, const ProbeSources* sources,
             const MapCache* cache, ShownProbes* shown, const LevelNeeds* needs)
      : content_(content),
        entries_(entries),
        keys_(keys),
        sources_(sources),
        cache_(cache),
        shown_(shown),
        needs_(needs) {}

  /// Not of a file. The probe of a bounce, a drag or a realtime job must exist. `publish` is called once, at the end.
  BakeItem item(const ProbeJob& job, const Publish& publish) const;

 private:
  BakeItem sky() const;
  BakeItem picture(const ProbeJob& job) const;
  BakeItem bounce(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) const;
  BakeItem realtime(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces) const;
  FaceSource faceSource(const Probe& probe, int face) const;
  void seeBounce(const ProbeJob& job) const;

  SceneContent* content_;
  const ProbeEntries* entries_;
  const ProbeKeys* keys_;
  const ProbeSources* sources_;
  const MapCache* cache_;
  ShownProbes* shown_;
  const LevelNeeds* needs_;
};

}  // namespace boxprobe
