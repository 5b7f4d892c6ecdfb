// The probes of one renderer at work: what of them has to be captured, captured and filtered step by step, and who is
// lit by what. A scene's renderer and the probes of other programs' actors both stand on it; they tell it what captures
// see (CaptureInputs), hand it their objects and lights (SceneContent), and ask for a step of work.
//
//   ProbePlan     what has to be made, in which order, by key: no OpenGL, no VTK
//   ProbeBaker    makes it and shows it
//   ProbeBinder   who is lit by what
//   DriverTuning  programs made for what is there, and ahead; other programs' actors go without
//
// A baked probe is made once for given inputs (capture_key.h), kept for undo, and taken from a file where one with the
// same key lies. A realtime probe follows what it shows: one face per step, only faces that changed, and the new maps
// replace the old ones whole, so that no half of one moment is seen beside half of another. A custom probe is filtered
// from a picture.
#pragma once

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
  /// Of a scene, whose content and state must outlive this: every kind of probe, programs compiled ahead.
  ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state);
  /// Of somebody else's actors: captures take probes as `captured` has them, which stands beside the content's own; all
  /// mip levels are filtered, since nobody knows what the actors' materials will be; no map is kept for undo.
  ProbeSet(SceneContent* content, const std::shared_ptr<DrawState>& state, const Scene* captured);
  ~ProbeSet();
  ProbeSet(const ProbeSet&) = delete;  // its parts know each other by address
  ProbeSet& operator=(const ProbeSet&) = delete;

  ProbePlan& plan() { return plan_; }
  const ProbePlan& plan() const { return plan_; }
  ProbeBaker& baker() { return baker_; }
  const ProbeBaker& baker() const { return baker_; }
  ProbeBinder& binder() { return binder_; }
  const ProbeBinder& binder() const { return binder_; }
  DriverTuning& tuning() { return tuning_; }
  /// Off, everything is drawn by general programs, each compiled when it is first drawn with.
  void setTuned(bool tuned);

  /// Takes over boxes, weights and techniques from the scene: uniforms only. `origins`: where each probe of the list
  /// was before, if the caller knows; else they are known by their names. The caller assigns.
  void updateShapes(const std::optional<ProbeEntries::Origins>& origins = {});
  /// Finds out which captures an edit has made stale; shows maps made before where there are any; starts or stops work.
  void updateCaptures(CaptureInputs inputs);
  /// Shows maps from elsewhere in place of captures; null: captures again. updateCaptures() follows.
  void give(std::size_t index, std::shared_ptr<const ProbeMaps> maps);

  void setInteractive(bool interactive);
  void setEnabled(bool enabled);
  /// See SceneRenderer::showCoarseFirst.
  void setCoarseFirst(bool coarse);
  void setBakeTargets(const std::vector<std::string>& names);
  void useBakedFiles(const std::string& folder);
  /// These are made again although nothing changed; updateCaptures() follows.
  void requestBake(const std::vector<std::string>& names);
  std::vector<std::string> bakeKeys(const std::string& probeName) const;
  /// On pictures of custom probes and on damaged baked files, one sentence each.
  std::vector<std::string> sourceRemarks() const;
  /// Drops all work until something changes.
  void giveUp();

  /// What a frame showed, as indices of objects: of many probes only those are made that something in it is lit by.
  /// Nothing: not known, as if all were.
  void setSeen(std::optional<std::vector<std::size_t>> objects);
  /// Does what is made follow from what frames show?
  bool followsSeen() const { return plan_.enabled() && plan_.targets().empty(); }

  bool workPending() const {
    return sightPending() || baker_.pending() || levelsPending() || latticePending() != nullptr ||
           toMeasure().has_value() || (with_.state->tuning != nullptr && tuning_.pending());
  }
  void step();
  /// From 0 to 1, of all that was planned since there last was nothing to do; below 1 while anything is pending.
  double progress() const;
  WorkNow workNow() const;

  /// What a probe shows now; null while it has none, or if there is no such probe.
  std::shared_ptr<const ProbeMaps> maps(const std::string& probeName) const;
  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const { return binder_.drawn(index).maps; }
  std::optional<ProbeDiffuse> diffuseLight(std::size_t index) const;

  std::size_t memoryBytes() const;
  /// Frees what the graphics side holds, with its context current. Everything is made again afterwards.
  void release();

 private:
  std::optional<std::size_t> toMeasure() const;
  bool sightPending() const { return plan_.enabled() && binder_.sightPending(); }
  /// Not while a handle is dragged, which is to change uniforms and no more: what it newly lights shows plain means of
  /// the capture until it is let go.
  bool levelsPending() const { return !plan_.interactive() && binder_.needs().lacking(); }
  /// Maps whose lattice is being derived beside the frames; the frame after that shows it.
  const ProbeMaps* latticePending() const;
  void doOne();
  void makeLevel();
  void makeAnew(std::size_t index);

  ProbeContext with_;
  ProbePlan plan_;
  ProbeBaker baker_;
  ProbeBinder binder_;
  DriverTuning tuning_;
  int levelsMade_ = 0;  ///< since there last was nothing to do
  int given_ = 0;       ///< maps so far
};

}  // namespace boxprobe
