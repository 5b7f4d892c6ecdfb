// Which programs are compiled before they are needed: for a box that is dragged, for what stands in while something
// moves, and, at rest, with numbers as constants. Told when objects get other bindings; makes no maps.
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

class ProbePrograms : public ProgramWork {
 public:
  /// `with` and all that it points to must outlive this.
  explicit ProbePrograms(const ProbeContext& with) : with_(with) {}

  bool known(const ProbeBinding& now, const ProbeBinding& next) const override;
  void assigned() override;
  void replanned() override;

  /// Boxes may be dragged: the programs that takes are compiled ahead. Takes effect with the next assignment.
  void setEditable(bool editable) { editable_ = editable; }
  /// Stand-ins may be shown: their programs are compiled ahead, too.
  void allowStandIns(bool allowed);
  /// Draws by stand-ins, as far as they are compiled and unless a capture that lasts is under way, which must not see
  /// them. Returns whether any object is.
  bool setMoving(bool moving);
  bool moving() const { return moving_; }

  /// Nothing has been edited for a while: programs with the numbers that rest as constants are compiled, one a call of
  /// prepareOne(), and shown once they are there. Until objects are assigned next.
  void foldConstants();

  /// Is there a program to compile, and nothing moves meanwhile?
  bool pending() const;
  void prepareOne();
  void giveUp() {
    toPrepare_.clear();
    toFold_.clear();
  }

 private:
  void updateStandIns();
  void prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding);
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
