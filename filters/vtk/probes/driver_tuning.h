// All tuning for drivers: programs specialized for a material's facts, for values at rest, for captures without
// reflections; flat pictures of maps for software renderers; programs compiled before a drag or a moving camera needs
// them; and an LRU cache of programs. The probe set of a scene has one, and its draw state refers to it while it is
// enabled.
#pragma once

#include <memory>
#include <optional>
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
  /// `with` and everything it points to must outlive this object.
  explicit DriverTuning(const ProbeContext& with) : with_(with) {}

  ProgramTraits choose(const TunedDraw& draw) override;
  std::uint64_t uses(vtkShaderProgram* program, bool constants) override;
  std::uint64_t compilation(const vtkShaderProgram* program) const override { return cache_.compilation(program); }
  void frameEnded(vtkOpenGLRenderWindow* window) override;
  bool known(const ProbeBinding& now, const ProbeBinding& next) const override;
  void assigned() override;
  void replanned() override;

  /// All by default.
  void setParts(TuningParts parts) { parts_ = parts; }

  /// Boxes may be dragged: compiles the programs for that ahead. Takes effect with the next assignment.
  void setEditable(bool editable) { editable_ = editable; }
  /// Cheap techniques may be shown while something moves: compiles their programs ahead, too.
  void allowStandIns(bool allowed);
  /// Draws with cheap techniques as far as they are compiled, except during a capture, which must not see them. Returns
  /// whether any object does.
  bool setMoving(bool moving);
  bool moving() const { return moving_; }

  /// To be called when nothing has been edited for a while: compiles programs with constants, one per call of
  /// prepareOne(), and uses them when ready. Lasts until objects are assigned again.
  void makeConstants();

  /// Is there a program to compile, while nothing moves?
  bool pending() const;
  void prepareOne();
  void cancelWork() {
    toPrepare_.clear();
    toMake_.clear();
  }

 private:
  void updateStandIns();
  void prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding);
  /// Chooses the facts for each object's program.
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
  std::optional<bool> onCpu_;  ///< tunedForCpu(), determined in the first draw
  std::shared_ptr<std::size_t> flatBytes_ = std::make_shared<std::size_t>(0);  ///< of all flat pictures
  bool editable_ = false, standInsAllowed_ = false, moving_ = false;

  std::set<std::string> variantsUsed_;  ///< program variants that objects have had so far
  /// Objects, with their bindings for a drag or a moving camera.
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>> toPrepare_;
  std::set<std::string> prepared_;  ///< variant and material
  std::vector<ConstantsJob> toMake_;
};

}  // namespace boxprobe
