// The tuning for drivers, all of it: programs that are made for a material's facts, for numbers at rest, for captures
// without reflections; flat pictures of maps for software renderers; programs compiled before a drag or a moving camera
// needs them, and an LRU cache of those that were drawn with. The probe set of a scene has one, and its draw state
// refers to it while it is switched on. Makes no maps.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filters/vtk/draw/program_cache.h"
#include "filters/vtk/draw/program_tuning.h"
#include "filters/vtk/probes/probe_context.h"

namespace boxprobe {

class DriverTuning : public ProgramTuning {
 public:
  /// `with` and all that it points to must outlive this.
  explicit DriverTuning(const ProbeContext& with) : with_(with) {}

  ProgramTraits choose(const TunedDraw& draw) override;
  std::uint64_t uses(vtkShaderProgram* program, bool constants) override;
  std::uint64_t compilation(const vtkShaderProgram* program) const override { return cache_.compilation(program); }
  void frameEnded(vtkOpenGLRenderWindow* window) override;
  bool known(const ProbeBinding& now, const ProbeBinding& next) const override;
  void assigned() override;
  void replanned() override;

  /// All, unless set.
  void setParts(TuningParts parts) { parts_ = parts; }

  /// Boxes may be dragged: the programs that takes are compiled ahead. Takes effect with the next assignment.
  void setEditable(bool editable) { editable_ = editable; }
  /// Stand-ins may be shown: their programs are compiled ahead, too.
  void allowStandIns(bool allowed);
  /// Draws by stand-ins, as far as they are compiled and unless a capture that lasts is under way, which must not see
  /// them. Returns whether any object is.
  bool setMoving(bool moving);
  bool moving() const { return moving_; }

  /// Nothing has been edited for a while: programs with the numbers as constants are compiled, one a call of
  /// prepareOne(), and shown once they are there. Until objects are assigned next.
  void makeConstants();

  /// Is there a program to compile, and nothing moves meanwhile?
  bool pending() const;
  void prepareOne();
  void giveUp() {
    toPrepare_.clear();
    toMake_.clear();
  }

 private:
  void updateStandIns();
  void prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding);
  /// What each object's program may take for granted.
  void planFacts();
  void dropConstants();
  void makeNextConstants();
  bool makeFlatMaps(const ProbeBinding& binding);

  /// Objects that share a program with these constants.
  struct ConstantsJob {
    std::shared_ptr<const ConstantsPlan> plan;
    std::vector<std::size_t> objects;
  };

  const ProbeContext& with_;
  ProgramCache cache_;
  TuningParts parts_ = kAllTuning;
  bool editable_ = false, standInsAllowed_ = false, moving_ = false;

  std::set<std::string> variantsUsed_;  ///< program variants objects have had so far
  /// Object, its binding in a drag or while the camera moves.
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>> toPrepare_;
  std::set<std::string> prepared_;  ///< variant and material
  std::vector<ConstantsJob> toMake_;
};

}  // namespace boxprobe
