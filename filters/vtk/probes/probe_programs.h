// Which probes each object is drawn with, what stands in for them while something moves, and which programs are
// compiled before they are needed. Called when shapes, techniques or maps change; makes no maps.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/resting_values.h"
#include "filters/vtk/probes/probe_context.h"

namespace boxprobe {

class ProbePrograms {
 public:
  /// `with` and all that it points to must outlive this.
  explicit ProbePrograms(const ProbeContext& with) : with_(with) {}

  /// Gives every object the probes whose influence meets it; during a drag only as far as there are programs for it
  /// already.
  void assign();
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
  bool pending() const;
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

  const ProbeContext& with_;
  bool editable_ = false, standInsAllowed_ = false, moving_ = false;

  std::set<std::string> variantsUsed_;  ///< program variants objects have had so far
  /// Object, its binding in a drag or while the camera moves.
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>> toPrepare_;
  std::set<std::string> prepared_;  ///< variant and material
  std::vector<Fold> toFold_;
};

}  // namespace boxprobe
