/**
 * @class   vtkActorProbesPass
 * @brief   lights one actor by reflection probes, whatever mapper of VTK's draws it
 *
 * VTK asks the render passes that an actor's property keys name to edit the shader text its mapper has written, and to
 * upload what the edits read; helpers of composite and glyph mappers ask, too. This one draws nothing itself: it puts
 * the splice (vtk_pbr_splice.h) in and uploads its uniforms. Taken off, the mapper builds VTK's own program again.
 * (Events and replacements of a vtkShaderProperty would not do: VTK's glyph mapper sends no UpdateShaderEvent, and
 * replacements are applied in alphabetical order, while the splice's build on each other.)
 *
 * An assembly gives its own keys to each part it draws, so the pass of a part lies in the assembly's keys.
 *
 * What is not shaded physically (unlit, Phong, lines without normals) keeps VTK's program, which writes display
 * colours; captures get their linear light, so that a reflection looks like the surface.
 */
#pragma once

#include <vtkInformation.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h>
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
  bool emission = false;            ///< emissive factors show without an emissive texture
  double exposure = 1.0;            ///< of the renderer's pictures
  vtkRenderer* renderer = nullptr;  ///< what is being drawn now; its camera is what uniforms go by. Null: draw as VTK
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
  /** The same, if the last one was built while nothing of ours was to be drawn. */
  void RebuildIfPlain();

  /**
   * Adds this pass to the keys of `owner`: the actor itself, or the assembly that draws it. Nothing happens where it is
   * there already; keys that were replaced meanwhile get it again.
   */
  void Attach(vtkActor* actor, vtkProp* owner);
  /** Takes it out and leaves the keys as they were found. */
  void Detach();
  /** Has a mapper asked for it since it was attached? */
  bool HasRun() const { return this->Run; }
  /** Does the actor draw with a pass of another object, added before? */
  static bool HasOther(vtkActor* actor, const vtkActorProbesPass* own);

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

  bool IsFor(vtkProp* prop) const;

  std::shared_ptr<boxprobe::ActorDraws> Draws;
  std::shared_ptr<const boxprobe::ProbeBinding> Binding;
  vtkWeakPointer<vtkActor> Actor;
  vtkWeakPointer<vtkProp> Owner;
  vtkSmartPointer<vtkInformation> Keys;  // that it lies in: VTK 9.1 does not let go of it where they are thrown away
  bool KeysMade = false;                 // the owner had none
  std::string VariantKey;
  vtkTimeStamp Built;    // when the program last had to be another
  bool Refused = false;  // by the driver: VTK's own is drawn
  bool Plain = false;    // built while nothing of ours was to be drawn
  bool Run = false;
};
