// Which probes each object is drawn with, what stands in for them while something moves, and which programs are
// compiled before they are needed. Called when shapes, techniques or maps change; makes no maps.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filters/vtk/capture/cube_capture.h"
#include "filters/vtk/draw/resting_values.h"
#include "filters/vtk/probes/level_needs.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class ProbePrograms {
 public:
  /// All pointers must outlive this.
  ProbePrograms(SceneContent* content, std::shared_ptr<DrawState> state, CubeCapture* capture, ProbeEntries* entries,
                const ProbePlan* plan, const ShownProbes* shown, LevelNeeds* needs)
      : content_(content),
        state_(std::move(state)),
        capture_(capture),
        entries_(entries),
        plan_(plan),
        shown_(shown),
        needs_(needs) {}

  /// Gives every object the probes whose influence meets it; during a drag only as far as there are programs for it
  /// already.
  void assign() { assign(!plan_->interactive()); }
  /// The same, whether a program has to be compiled for it or not.
  void assignAll() { assign(true); }

  /// Boxes may be dragged: the programs that takes are compiled ahead. Takes effect with the next assign().
  void setEditable(bool editable) { editable_ = editable; }
  /// Stand-ins may be shown: their programs are compiled ahead, too.
  void allowStandIns(bool allowed);
  /// Draws by stand-ins, as far as they are compiled and unless a capture that lasts is under way, which must not see
  /// them. Returns whether any object is.
  bool setMoving(bool moving);
  bool moving() const { return moving_; }
  /// To be called when captures begin or end.
  void updateStandIns();

  /// Nothing has been edited for a while: programs with the numbers that rest as constants are compiled, one a call of
  /// prepareOne(), and shown once they are there. Until assign() is called next, which leaves them.
  void foldConstants();

  /// Is there a program to compile, and nothing moves meanwhile?
  bool pending() const { return !plan_->interactive() && !moving_ && (!toPrepare_.empty() || !toFold_.empty()); }
  void prepareOne();
  void giveUp() {
    toPrepare_.clear();
    toFold_.clear();
  }

 private:
  void assign(bool newProgramsAllowed);
  void prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding);
  void recordUse();
  /// What each object's program may take for granted.
  void foldFacts();
  void unfoldConstants();
  void foldNext();

  /// Objects that share a program with these constants.
  struct Fold {
    std::shared_ptr<const ConstantsPlan> plan;
    std::vector<std::size_t> objects;
  };

  SceneContent* content_;
  std::shared_ptr<DrawState> state_;
  CubeCapture* capture_;
  ProbeEntries* entries_;
  const ProbePlan* plan_;
  const ShownProbes* shown_;
  LevelNeeds* needs_;
  bool editable_ = false, standInsAllowed_ = false, moving_ = false;

  std::set<std::string> variantsUsed_;  ///< program variants objects have had so far
  /// Object, its binding in a drag or while the camera moves.
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>> toPrepare_;
  std::set<std::string> prepared_;  ///< variant and material
  std::vector<Fold> toFold_;
};

}  // namespace boxprobe
