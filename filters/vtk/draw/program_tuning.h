// What may be done for a driver's sake: programs made for the very material, numbers and pass of a draw, compiled ahead
// of their first use, released when they have not been used for long. One object does it all (probes/driver_tuning.h);
// without one everything is drawn by general programs, each compiled when it is first drawn with, and looks the same to
// 1/255.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "filters/vtk/draw/constants.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/refined_rays.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/tuning_parts.h"

class vtkActor;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

/// What an object asks for, of itself or because it was planned for it.
struct ProgramRequest {
  bool standIn = false;  ///< by what stands in for its techniques (see EvaluationRow)
  RefinedRays refined;   ///< by rays in place of its techniques (see ProbeBinding::refined)
  SurfaceFacts facts = kAnyFact;
  std::shared_ptr<const ConstantsPlan> constants;  ///< null: none
};

/// What a draw's program is made for beyond what the picture needs.
struct ProgramTraits {
  std::shared_ptr<const ProbeBinding> firstBounce;  ///< in place of the binding, where no probe reflects; null: that
  std::shared_ptr<const ProbeBinding> firstBounceOf;
  std::shared_ptr<const ConstantsPlan> constants;  ///< null: numbers are uniforms
  SurfaceFacts facts = 0;
  bool flatMaps = false;  ///< with constants alone: maps are looked up in flat pictures of them
};

/// The draw that is about to begin.
struct TunedDraw {
  vtkActor* actor;
  const SurfaceMaterial* surface;                      ///< null: VTK's own material code
  const std::shared_ptr<const ProbeBinding>& binding;  ///< null: none
  const std::string& variant;                          ///< of that
  const ProgramRequest& request;
  const ProgramTraits& made;  ///< what the program it was drawn with last is made for
  bool picture;               ///< it draws the picture, not a debug view or a mirror's heights
  bool looksElsewhere;        ///< a mirror's picture or glass: it looks up more than probes
  bool refused;               ///< the driver refused the program, or that with constants
};

class ProgramTuning {
 public:
  virtual ~ProgramTuning() = default;

  // Within a frame.
  virtual ProgramTraits choose(const TunedDraw& draw) = 0;
  /// The object is drawn with `program` now. Returns a number that is another one when it is compiled again.
  virtual std::uint64_t uses(vtkShaderProgram* program, bool constants) = 0;
  virtual std::uint64_t compilation(const vtkShaderProgram* program) const = 0;
  virtual void frameEnded(vtkOpenGLRenderWindow* window) = 0;

  // Between frames.
  /// May an object that is drawn by `now` be drawn by `next` without waiting for a program?
  virtual bool known(const ProbeBinding& now, const ProbeBinding& next) const = 0;
  /// Objects may have other bindings.
  virtual void assigned() = 0;
  /// Captures may have begun or ended.
  virtual void replanned() = 0;
};

}  // namespace boxprobe
