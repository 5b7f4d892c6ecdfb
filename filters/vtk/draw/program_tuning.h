// Optional work for the driver's sake: programs specialized for the material, values and pass of a draw, compiled ahead
// of their first use, released after disuse. Implemented by one object (probes/driver_tuning.h). Without it, objects
// have general programs, compiled at the first draw, and the picture is the same to 1/255.
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

/// What an object requests, by itself or because it was planned.
struct ProgramRequest {
  bool standIn = false;  ///< cheap techniques in place of its own (see EvaluationRow)
  RefinedRays refined;   ///< rays in place of its techniques (see ProbeBinding::refined)
  SurfaceFacts facts = kAnyFact;
  std::shared_ptr<const ConstantsPlan> constants;  ///< null: none
};

/// What a draw's program is specialized for beyond what the picture needs.
struct ProgramTraits {
  std::shared_ptr<const ProbeBinding> firstBounce;  ///< replaces the binding where no probe reflects; null: none
  std::shared_ptr<const ProbeBinding> firstBounceOf;
  std::shared_ptr<const ConstantsPlan> constants;  ///< null: values are uniforms
  SurfaceFacts facts = 0;
  bool flatMaps = false;  ///< only with constants: flat pictures of maps are sampled
};

/// The draw that is about to start.
struct TunedDraw {
  vtkActor* actor;
  const SurfaceMaterial* surface;                      ///< null: VTK's own material code
  const std::shared_ptr<const ProbeBinding>& binding;  ///< null: none
  const std::string& variant;                          ///< key of the binding
  const ProgramRequest& request;
  const ProgramTraits& made;  ///< traits of the program it was last drawn with
  bool picture;               ///< it draws the picture, not a debug view or a mirror's heights
  bool samplesOtherPictures;  ///< a mirror's picture or glass: it samples more than probes
  bool refused;               ///< the driver refused the program, or the specialized one
};

class ProgramTuning {
 public:
  virtual ~ProgramTuning() = default;

  // Called within a frame:
  virtual ProgramTraits choose(const TunedDraw& draw) = 0;
  /// The object is now drawn with `program`. Returns a number that changes when it is compiled again.
  virtual std::uint64_t uses(vtkShaderProgram* program, bool constants) = 0;
  virtual std::uint64_t compilation(const vtkShaderProgram* program) const = 0;
  virtual void frameEnded(vtkOpenGLRenderWindow* window) = 0;

  // Called between frames:
  /// May an object that is drawn with `now` be drawn with `next` without waiting for a program?
  virtual bool known(const ProbeBinding& now, const ProbeBinding& next) const = 0;
  /// To be called when bindings may have changed.
  virtual void assigned() = 0;
  /// To be called when captures may have started or ended.
  virtual void replanned() = 0;
};

}  // namespace boxprobe
