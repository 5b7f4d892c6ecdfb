// The probes of one renderer: plans captures, captures and filters step by step, and binds probes to objects. The basis
// of both the scene renderer and probes for actors of other programs, which describe what captures see (CaptureInputs),
// pass their objects and lights (SceneContent), and call step().
//
//   ProbePlan     what has to be made, in which order, by key: no OpenGL, no VTK
//   ProbeBaker    makes it and shows it
//   ProbeBinder   who is lit by what
//   DriverTuning  programs made for what is there, and ahead; other programs' actors go without
//
// A baked probe is made once for given inputs (capture_key.h), kept for undo, and read from a file if one has the same
// key. A realtime probe is recaptured as the scene changes: one face per step, only changed faces; complete new maps
// replace the old ones, so that two moments are never mixed. A custom probe is filtered from a picture.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/geometry/probe_diffuse.h"
#include "filters/vtk/probes/driver_tuning.h"
#include "filters/vtk/probes/probe_baker.h"
#include "filters/vtk/probes/probe_binder.h"
#include "filters/vtk/probes/probe_plan.h"

namespace boxprobe {

class ProbeSet {
 public:
  /// For a scene, whose content and state must outlive this object: all kinds of probes, programs compiled ahead.
  ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state);
  /// For actors of other programs: captures use the probes of `captured`, which are separate from the content's; all
  /// mip levels are filtered, since future materials are unknown; unused maps are not kept.
  ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state, const Scene* captured);
  ~ProbeSet();
  ProbeSet(const ProbeSet&) = delete;  // its parts refer to each other by address
  ProbeSet& operator=(const ProbeSet&) = delete;

  ProbePlan& plan() { return plan_; }
  const ProbePlan& plan() const { return plan_; }
  ProbeBaker& baker() { return baker_; }
  const ProbeBaker& baker() const { return baker_; }
  ProbeBinder& binder() { return binder_; }
  const ProbeBinder& binder() const { return binder_; }
  DriverTuning& tuning() { return tuning_; }
  /// Off: everything is drawn by general programs, compiled at their first draw.
  void setTuned(bool tuned);

  /// Applies boxes, weights and techniques of the scene, as uniforms only. `origins`: previous indices of the probes,
  /// if known; otherwise they are matched by name. Does not assign.
  void updateShapes(const std::optional<ProbeEntries::Origins>& origins = {});
  /// Determines which captures are stale after an edit, shows maps made earlier, and starts or stops work.
  void updateCaptures(CaptureInputs inputs);
  /// Shows maps from elsewhere in place of captures; null: captures again. updateCaptures() must follow.
  void give(std::size_t index, std::shared_ptr<const ProbeMaps> maps);

  void setInteractive(bool interactive);
  void setEnabled(bool enabled);
  /// See SceneRenderer::showCoarseFirst.
  void setCoarseFirst(bool coarse);
  /// See ProbePlan::setSharp.
  void setSharp(std::map<std::string, int> faceSizes);
  void setBakeTargets(const std::vector<std::string>& names, const std::vector<std::string>& cutShort);
  void useBakedFiles(const std::string& folder);
  /// Makes these again although nothing has changed; updateCaptures() must follow.
  void requestBake(const std::vector<std::string>& names);
  std::vector<std::string> bakeKeys(const std::string& probeName) const;
  /// About pictures of custom probes and damaged baked files, one sentence each.
  std::vector<std::string> sourceRemarks() const;
  /// Drops all work until something changes.
  void cancelWork();

  /// The objects of the last frame, as indices: if there are many probes, only those that light one of these are made.
  /// Nothing: unknown, as if all were visible.
  void setSeen(std::optional<std::vector<std::size_t>> objects);
  /// Does the plan depend on what frames show?
  bool followsSeen() const { return plan_.enabled() && plan_.targets().empty(); }

  bool workPending() const {
    return sightPending() || baker_.pending() || levelsPending() || latticePending() != nullptr ||
           toMeasure().has_value() || (with_.state->tuning != nullptr && tuning_.pending());
  }
  void step();
  /// From 0 to 1, of everything planned since there was nothing to do; below 1 while anything is pending.
  double progress() const;
  WorkNow workNow() const;

  /// A probe's current maps; null if it has none, or does not exist.
  std::shared_ptr<const ProbeMaps> maps(const std::string& probeName) const;
  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const { return binder_.drawn(index).maps; }
  std::optional<ProbeDiffuse> diffuseLight(std::size_t index) const;

  std::size_t memoryBytes() const;
  /// Releases GPU resources, with their context current. Everything is made again afterwards.
  void release();

 private:
  std::optional<std::size_t> toMeasure() const;
  bool sightPending() const { return plan_.enabled() && binder_.sightPending(); }
  /// Not during a drag, which only changes uniforms: until its end, newly lit objects show plain means of the capture.
  bool levelsPending() const { return !plan_.interactive() && binder_.needs().lacking(); }
  /// Maps whose lattice is being derived on other threads; the frame after that shows it.
  const ProbeMaps* latticePending() const;
  void updateKeys();
  void doOne();
  void makeLevel();
  void makeAnew(std::size_t index);

  ProbeContext with_;
  ProbePlan plan_;
  ProbeBaker baker_;
  ProbeBinder binder_;
  DriverTuning tuning_;
  int levelsMade_ = 0;  ///< since there was nothing to do
  int given_ = 0;       ///< number of maps so far
};

}  // namespace boxprobe
