// The probes of a scene at work, as the scene renderer uses them: which maps each one shows, what is made for them, and
// which object uses which probe. Owned by the scene renderer; puts its parts in touch and holds nothing else:
//
//   ProbeEntries    what each probe shows and should show, by key      ProbeKeys   those keys
//   ProbePlan       what has to be made, in which order                ProbeBaker  makes it and shows it
//   ShownProbes     the maps probes are drawn with                     ProbeLight, ProbeErrors   what follows from them
//   ProbePrograms   which object is drawn with which probes
//
// A baked probe is made once for given inputs (capture_key.h, bounce_keys.h), kept for undo, and taken from a file
// where one with the same key lies. A realtime probe follows what it shows: one face per step, only faces that changed,
// and the new maps replace the old ones whole, so that no half of one moment is seen beside half of another. A custom
// probe is filtered from a picture.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/capture_inputs.h"
#include "filters/vtk/probes/level_needs.h"
#include "filters/vtk/probes/probe_baker.h"
#include "filters/vtk/probes/probe_errors.h"
#include "filters/vtk/probes/probe_light.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/probe_programs.h"
#include "filters/vtk/probes/shown_probes.h"

namespace boxprobe {

class ProbeSet {
 public:
  ProbeSet(vtkOpenGLRenderWindow* window, const std::shared_ptr<DrawState>& state, CubeCapture* capture,
           SceneContent* content, Times* times);
  ProbeSet(const ProbeSet&) = delete;  // its parts know each other by address
  ProbeSet& operator=(const ProbeSet&) = delete;

  /// Takes over boxes, weights and techniques from the scene: uniforms only.
  void updateShapes();
  /// Gives every object the probes whose influence meets it; during a drag only as far as there are programs for it
  /// already.
  void assignToObjects() { programs_.assign(); }
  /// Finds out which captures an edit has made stale; shows maps made before where there are any; starts or stops work.
  void updateCaptures();

  void setInteractive(bool interactive);
  void setEnabled(bool enabled);
  /// Someone may start to drag a box: the programs that takes are compiled ahead, as work of the lowest priority.
  void setEditable(bool editable) { programs_.setEditable(editable); }
  /// The camera or a handle may be moved with cheaper techniques on the screen: their programs are compiled ahead, too.
  void allowStandIns(bool allowed) { programs_.allowStandIns(allowed); }
  /// Draws by them, as far as they are compiled and unless a capture that lasts is under way, which must not see them.
  /// Returns whether any object is.
  bool setMoving(bool moving) { return programs_.setMoving(moving); }
  /// See the scene renderer's functions of these names.
  void foldConstants() { programs_.foldConstants(); }
  void setBakeTargets(const std::vector<std::string>& names);
  void useBakedFiles(const std::string& folder);
  void requestBake(const std::vector<std::string>& names);
  BakeState bakeState(const std::string& probeName) const { return plan_.state(probeName); }
  std::vector<std::string> bakeKeys(const std::string& probeName) const;
  const std::string& pictureError() const { return sources_.pictures.error(); }
  /// On pictures of custom probes and on damaged baked files, one sentence each.
  std::vector<std::string> sourceRemarks() const;
  /// Empty, or why nothing is made: the maps would not fit into the graphics memory.
  const std::string& memoryError() const { return plan_.memoryError(); }
  /// Drops all work until something changes.
  void giveUp();
  /// What the maps a baked probe shows were made from; nothing while they are not the final ones. Empty: the sky.
  std::optional<BakeRecord> record(const std::string& probeName) const { return plan_.record(probeName); }

  /// What a frame showed, as indices of objects: of many probes only those are made that something in it is lit by.
  /// Nothing: not known, as if all were.
  void setSeen(std::optional<std::vector<std::size_t>> objects);
  /// Does what is made follow from what frames show?
  bool followsSeen() const { return plan_.enabled() && plan_.targets().empty(); }

  bool workPending() const {
    return sightPending() || baker_.pending() || levelsPending() || toMeasure().has_value() || programs_.pending();
  }
  void step();
  /// From 0 to 1, of all that was planned since there last was nothing to do; below 1 while anything is pending.
  double progress() const;
  /// What is drawn beside the scene's objects samples these levels of these maps; null: nothing does.
  void alsoSampled(const std::shared_ptr<const ProbeMaps>& maps, LevelMask levels) { needs_.also(maps, levels); }

  /// What a probe shows now; null while it has none, or if there is no such probe.
  std::shared_ptr<const ProbeMaps> maps(const std::string& probeName) const;
  std::optional<ShCoefficients> diffuseLight(const std::string& probeName) const;

  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const { return shown_.drawn(index).maps; }

  std::size_t memoryBytes() const;
  void release();

 private:
  std::optional<std::size_t> toMeasure() const;
  bool sightPending() const { return plan_.enabled() && light_.sightPending(); }
  /// Not while a handle is dragged, which is to change uniforms and no more: what it newly lights shows plain means of
  /// the capture until it is let go.
  bool levelsPending() const { return !plan_.interactive() && needs_.lacking(); }
  void doOne();
  void makeLevel();
  void updateKeys();
  void makeAnew(std::size_t index);

  ProbeContext with_;
  MapCache cache_;
  CaptureInputs inputs_;
  ProbeSources sources_;
  ProbeEntries entries_;
  ProbeKeys keys_;
  ProbePlan plan_;
  ShownProbes shown_;
  LevelNeeds needs_;
  ProbeLight light_;
  ProbeErrors errors_;
  ProbePrograms programs_;
  ProbeBaker baker_;
  int levelsMade_ = 0;  ///< since there last was nothing to do
};

}  // namespace boxprobe
