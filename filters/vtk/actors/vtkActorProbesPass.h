/**
 * @class   vtkActorProbesPass
 * @brief   lights one actor by reflection probes, whatever mapper of VTK's draws it
 *
 * VTK asks the render passes that an actor's property keys name to edit the shader text its mapper has written, and to
 * upload what the edits read; helpers of composite and glyph mappers ask, too. This one draws nothing itself: it puts
 * the splice (vtk_pbr_splice.h) in and uploads its uniforms. Taken off, the mapper builds VTK's own program again.
 * (Events and replacements of a vtkShaderProperty would not do: VTK's glyph mapper sends no UpdateShaderEvent, and
 * replacements are applied in alphabetical order, while the splice's build on each other.)
 */
#pragma once

#include <vtkOpenGLRenderPass.h>
#include <vtkTimeStamp.h>
#include <vtkWeakPointer.h>

#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/gl/gl_objects.h"

class vtkActor;
class vtkRenderer;

namespace boxprobe {

/// What the passes of one renderer's actors share.
struct ActorDraws {
  DrawState state;
  bool emission = false;                             ///< emissive factors show without an emissive texture
  vtkRenderer* renderer = nullptr;                   ///< what is being drawn now; its camera is what uniforms go by
  std::vector<std::unique_ptr<BoundTexture>> bound;  ///< for the piece drawn last
};

}  // namespace boxprobe

class vtkActorProbesPass : public vtkOpenGLRenderPass {
 public:
  static vtkActorProbesPass* New();
  vtkTypeMacro(vtkActorProbesPass, vtkOpenGLRenderPass) void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetDraws(std::shared_ptr<boxprobe::ActorDraws> draws) { this->Draws = std::move(draws); }
  /** Another variant key means another program, built at the next draw; otherwise only uniforms change. */
  void SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding);
  /** Have the program built again. */
  void Rebuild();

  /** Adds this pass to the actor's keys; takes it out again and leaves the keys as they were found. */
  void Attach(vtkActor* actor);
  void Detach();

  ///@{
  /** VTK's side of it. */
  void Render(const vtkRenderState*) override {}
  bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                               vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
                           vtkOpenGLVertexArrayObject* vao = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Built.GetMTime(); }
  ///@}

 protected:
  vtkActorProbesPass();
  ~vtkActorProbesPass() override;

 private:
  vtkActorProbesPass(const vtkActorProbesPass&) = delete;
  void operator=(const vtkActorProbesPass&) = delete;

  std::shared_ptr<boxprobe::ActorDraws> Draws;
  std::shared_ptr<const boxprobe::ProbeBinding> Binding;
  vtkWeakPointer<vtkActor> Actor;
  bool KeysMade = false;  // the actor had none
  std::string VariantKey;
  vtkTimeStamp Built;    // when the program last had to be another
  bool Refused = false;  // by the driver: VTK's own is drawn
};
