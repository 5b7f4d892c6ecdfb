/**
 * @class   vtkProbePass
 * @brief   lights one actor by reflection probes, whatever mapper of VTK's draws it
 *
 * VTK asks the render passes that an actor's property keys name to edit the shader text its mapper has written, and to
 * upload what the edits read; helpers of composite and glyph mappers ask, too. This one draws nothing itself: it puts
 * the splice (vtk_pbr_splice.h) in and uploads its uniforms, relative to the camera, from double. Without a draw state
 * or a binding the mapper writes VTK's own program, and again once the pass is detached. (Events and replacements of a
 * vtkShaderProperty would not do: VTK's glyph mapper sends no UpdateShaderEvent, and replacements are applied in
 * alphabetical order, while the splice's build on each other.)
 *
 * Actors of other programs have it attached, and Prepare() need not be called. Those of this program's scenes are
 * vtkProbeActor, which has one, calls Prepare() before each draw, and draws glass in several passes.
 *
 * An assembly gives its own keys to each part it draws, so the pass of a part lies in the assembly's keys.
 *
 * What is not shaded physically (unlit, Phong, lines without normals) keeps VTK's program, which writes display
 * colours; captures get their linear light, so that a reflection looks like the surface.
 *
 * Whether the driver takes a program is asked of the text that it will get: with the edits of the passes after this one
 * and the actor's own replacements. VTK's own program is drawn in place of one that is refused.
 */
#pragma once

#include <vtkInformation.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h>
#include <vtkTimeStamp.h>
#include <vtkWeakPointer.h>

#include <cstdint>
#include <memory>
#include <string>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/frame_parts.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/program_tuning.h"
#include "filters/vtk/draw/surface_material.h"

class vtkActor;

namespace boxprobe {
enum class SurfaceOutput;
struct ShaderSources;
}  // namespace boxprobe

class vtkProbePass : public vtkOpenGLRenderPass {
 public:
  static vtkProbePass* New();
  vtkTypeMacro(vtkProbePass, vtkOpenGLRenderPass) void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds this pass to the keys of `owner`: the actor itself, or the assembly that draws it. Nothing happens where it is
   * there already; keys that were replaced meanwhile get it again.
   */
  void Attach(vtkActor* actor, vtkProp* owner);
  /** Takes it out and leaves the keys as they were found. */
  void Detach();
  /** Has a mapper asked for it since it was attached? */
  bool HasRun() const { return this->Last.run; }
  /** Does the actor draw with a pass of another object, added before? */
  static bool HasOther(vtkActor* actor, const vtkProbePass* own);

  void SetDrawState(std::shared_ptr<boxprobe::DrawState> state) { this->State = std::move(state); }
  boxprobe::DrawState* GetDrawState() const { return this->State.get(); }
  /** The material's textures and what the vertices bring; null: VTK's own material code. vtkProbeActor::SetShape()
   * tells the mapper of the vertices. */
  void SetSurface(std::shared_ptr<const boxprobe::SurfaceMaterial> surface);
  const boxprobe::SurfaceMaterial* GetSurface() const { return this->Surface.get(); }
  /** Another variant key means another program, built at the next draw; otherwise only uniforms change. */
  void SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding);
  const boxprobe::ProbeBinding* GetBinding() const { return this->Asked.binding.get(); }
  std::shared_ptr<const boxprobe::ProbeBinding> GetSharedBinding() const { return this->Asked.binding; }
  /** Draws by what stands in for the binding's techniques (see EvaluationRow), which the binding itself keeps. */
  void SetStandIn(bool standIn);
  /** Draws by so many rays in place of the binding's techniques, where that shows anything else and no stand-in is
   * asked for. */
  void SetRefined(boxprobe::RefinedRays rays);
  /** The binding as it is drawn: its stand-in or its rays, if those were asked for. */
  const boxprobe::ProbeBinding* GetDrawnBinding() const { return this->Made.binding.get(); }

  /** Keeps what techniques sample apart from the rest, in further attachments (see reflection_apart.glsl). */
  void SetSeparateSpecular(bool apart);
  bool GetSeparateSpecular() const { return this->Asked.separateSpecular; }
  /** Writes colour and height over a planar mirror, for the mirror's picture (see mirrored_output.glsl). */
  void SetHeights(bool heights);
  /** The surface is a planar mirror and looks that picture up where it is shown; null: it is none. */
  void SetMirror(std::shared_ptr<const boxprobe::MirrorPicture> mirror);
  std::shared_ptr<const boxprobe::MirrorPicture> GetMirror() const { return this->Mirror; }
  /** Draws with the debug view's program (see vtk_pbr_splice.h) instead of the picture's. */
  void SetDebug(bool debug);
  /** What a surface capture names this object by; 0 is the background's. */
  void SetObjectNumber(int number) { this->Asked.objectNumber = number; }
  /** To find what they cost: the picture is drawn without these parts, which makes it a wrong one (frame_parts.h). */
  void SetLeftOut(boxprobe::FrameParts parts);
  boxprobe::FrameParts GetLeftOut() const { return this->Asked.leftOut; }

  /** What its program may take for granted, as far as it holds (see surface_facts.h); by default whatever holds. A
   * material that no longer has what its program is made for gets another program at the next draw. */
  void SetRequestedFacts(boxprobe::SurfaceFacts facts) { this->Asked.tuning.facts = facts; }
  boxprobe::SurfaceFacts GetRequestedFacts() const { return this->Asked.tuning.facts; }
  /** Numbers its program may have as constants, as long as the draw's own are the same (see constants.h): where
   * they differ, or for any other variant, it is drawn by the program that has them as uniforms. Null: none. */
  void SetConstants(std::shared_ptr<const boxprobe::ConstantsPlan> plan);
  /** Did the driver, or the memory, refuse the program with the constants set last? It is drawn without them. */
  bool GetConstantsRefused() const { return this->Last.constantsRefused; }

  /** Is the surface glass, and lit so that it can be drawn as such? */
  bool DrawsGlass() const;
  /** Glass that what is drawn behind does not already show through by blending. */
  bool LooksBehind() const;
  /** The driver refused the debug program, and VTK's own was drawn: it writes the first attachment alone. */
  bool GetDebugRefused() const { return this->Asked.debug && this->Last.refused; }
  /** The OpenGL program it was drawn with last, as a number; 0: none. Equal numbers share one. */
  unsigned GetProgramNumber() const { return this->Last.programNumber; }
  /** Was it drawn by the frame that ended last? Captures and linear pictures do not count. */
  bool GetDrawnInFrame() const;

  /** Before `actor` is drawn: finds out what its program is to be made for, by its material and by the pass under way,
   * and has another one built where that is not what it was made for. */
  void Prepare(vtkActor* actor);
  /** Until it is prepared again: further draws of the same piece, which are not counted. */
  void SetAgain() { this->Again = true; }
  /** Have the program built again. */
  void Rebuild();
  /** The same, if the last one was built while nothing of ours was to be drawn. */
  void RebuildIfPlain();

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
  vtkProbePass();
  ~vtkProbePass() override;

 private:
  vtkProbePass(const vtkProbePass&) = delete;
  void operator=(const vtkProbePass&) = delete;

  /** What the program is to be. */
  struct Request {
    std::shared_ptr<const boxprobe::ProbeBinding> binding;
    bool separateSpecular = false, heights = false, debug = false;
    int objectNumber = 0;
    boxprobe::FrameParts leftOut = 0;
    boxprobe::ProgramRequest tuning;
  };
  /** What it is made for. */
  struct Variant {
    std::shared_ptr<const boxprobe::ProbeBinding> binding;  ///< the requested binding, or its cheap variant
    std::string key;                                        ///< variant key of the binding
    boxprobe::ProgramTraits traits;
    boxprobe::LightForm form = boxprobe::LightForm::Single;
    boxprobe::Tone tone = boxprobe::Tone::None;
    int glass = 0;
  };
  /** What became of it. */
  struct Outcome {
    bool refused = false;  ///< by the driver: VTK's own is drawn
    bool constantsRefused = false;
    bool plain = false;  ///< built while no draw of ours was in progress
    bool run = false;
    unsigned programNumber = 0;
    const vtkShaderProgram* program = nullptr;  ///< last drawn with; compared, never dereferenced
    std::uint64_t compilation = 0;              ///< of that program, see ProgramTuning::uses()
    std::uint64_t frame = ~std::uint64_t{0};    ///< the last frame that drew it
  };

  bool IsFor(vtkProp* prop) const;
  void UpdateDrawn();
  void ChooseTraits(vtkActor* actor);
  const boxprobe::ProbeBinding& Drawn() const {
    return this->Made.traits.firstBounce ? *this->Made.traits.firstBounce : *this->Made.binding;
  }
  boxprobe::SurfaceOutput OutputOf(vtkActor* actor) const;
  bool Splice(boxprobe::ShaderSources& sources, vtkActor* actor, bool lit);
  bool Compiles(const boxprobe::ShaderSources& sources, vtkAbstractMapper* mapper, vtkActor* actor) const;
  void Refuse(vtkAbstractMapper* mapper, vtkActor* actor);
  void Upload(vtkShaderProgram* program, const double* boundsWorld);
  void Count(vtkShaderProgram* program);

  std::shared_ptr<boxprobe::DrawState> State;
  std::shared_ptr<const boxprobe::SurfaceMaterial> Surface;
  std::shared_ptr<const boxprobe::MirrorPicture> Mirror;
  Request Asked;
  Variant Made;
  Outcome Last;
  vtkTimeStamp Built;  ///< when the program last had to change
  bool Again = false;
  vtkWeakPointer<vtkActor> Actor;
  vtkWeakPointer<vtkProp> Owner;
  vtkSmartPointer<vtkInformation>
      Keys;               ///< the keys that contain it: VTK 9.1 does not release it when they are discarded
  bool KeysMade = false;  ///< the owner had no keys
};
