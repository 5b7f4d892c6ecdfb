/**
 * @class   vtkProbePass
 * @brief   lights one actor by reflection probes, whatever mapper of VTK's draws it
 *
 * VTK lets the render passes in an actor's property keys edit the shader source that its mapper has written, and upload
 * uniforms; the helpers of composite and glyph mappers do the same. This pass draws nothing itself: it inserts the
 * splice (vtk_pbr_splice.h) and uploads its uniforms, relative to the camera, from double. Without a draw state or a
 * binding, and after the pass is detached, the mapper writes VTK's own program. (Events and replacements of
 * vtkShaderProperty are not enough: VTK's glyph mapper sends no UpdateShaderEvent, and replacements are applied in
 * alphabetical order, while those of the splice depend on each other.)
 *
 * It is attached to actors of other programs, for which Prepare() need not be called. The scenes of this program
 * consist of vtkProbeActor, which has a pass, calls Prepare() before each draw, and draws glass in several passes.
 *
 * An assembly passes its own keys to each part that it draws, so the pass of a part is in the assembly's keys.
 *
 * Surfaces without physically based shading (unlit, Phong, lines without normals) keep VTK's program, which writes
 * display colours; captures convert them to linear light, so that a reflection looks like the surface.
 *
 * Programs are tested with the driver in their final form: with the edits of later passes and the actor's own
 * replacements. If the driver refuses one, VTK's own program is drawn instead.
 */
#pragma once

#include <vtkInformation.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkSmartPointer.h>
#include <vtkTimeStamp.h>
#include <vtkWeakPointer.h>

#include <cstdint>
#include <map>
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
   * Adds this pass to the keys of `owner`: the actor itself, or the assembly that draws it. Does nothing if it is there
   * already; adds it again if the keys were replaced.
   */
  void Attach(vtkActor* actor, vtkProp* owner);
  /** Removes it, and restores the keys. */
  void Detach();
  /** Has a mapper used it since it was attached? */
  bool HasRun() const { return this->Last.run; }
  /** Does the actor already have a pass of another object? */
  static bool HasOther(vtkActor* actor, const vtkProbePass* own);

  void SetDrawState(std::shared_ptr<boxprobe::DrawState> state) { this->State = std::move(state); }
  boxprobe::DrawState* GetDrawState() const { return this->State.get(); }
  /** The material's textures and vertex attributes; null: VTK's own material code. vtkProbeActor::SetShape() passes the
   * attributes to the mapper. */
  void SetSurface(std::shared_ptr<const boxprobe::SurfaceMaterial> surface);
  const boxprobe::SurfaceMaterial* GetSurface() const { return this->Surface.get(); }
  /** A binding with another variant key needs another program, built at the next draw; otherwise only uniforms change.
   * If the driver refuses that, GetBinding() is one with less (fewer_samplers.h) from then on. */
  void SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding);
  const boxprobe::ProbeBinding* GetBinding() const { return this->Asked.binding.get(); }
  std::shared_ptr<const boxprobe::ProbeBinding> GetSharedBinding() const { return this->Asked.binding; }
  /** Draws with cheap techniques instead of the binding's (see EvaluationRow::standIn); the binding is unchanged. */
  void SetStandIn(bool standIn);
  /** Draws with that many rays instead of the binding's techniques, if the result differs and cheap techniques are not
   * requested. */
  void SetRefined(boxprobe::RefinedRays rays);
  /** The binding as it is drawn: with cheap techniques or rays if requested. */
  const boxprobe::ProbeBinding* GetDrawnBinding() const { return this->Made.binding.get(); }
  /** How many of the material's textures are left out, because the driver has too few texture units. */
  std::size_t GetTexturesLess() const { return this->TexturesLess; }

  /** Writes sampled reflections separately, to further attachments (see reflection_apart.glsl). */
  void SetSeparateSpecular(bool apart);
  bool GetSeparateSpecular() const { return this->Asked.separateSpecular; }
  /** Writes colour and height over a planar mirror for the mirror's picture (see mirrored_output.glsl). */
  void SetHeights(bool heights);
  /** The picture of a surface that is a planar mirror, sampled while it is shown; null: not a mirror. */
  void SetMirror(std::shared_ptr<const boxprobe::MirrorPicture> mirror);
  std::shared_ptr<const boxprobe::MirrorPicture> GetMirror() const { return this->Mirror; }
  /** Draws with the debug view's program (see vtk_pbr_splice.h) instead of the picture's. */
  void SetDebug(bool debug);
  /** The number of this object in surface captures; 0 is the background. */
  void SetObjectNumber(int number) { this->Asked.objectNumber = number; }
  /** Draws without these parts, to measure their cost; the picture is then wrong (frame_parts.h). */
  void SetDisabledParts(boxprobe::FrameParts parts);
  boxprobe::FrameParts GetDisabledParts() const { return this->Asked.leftOut; }
  /** Not drawn by the renderer of the window's picture (DrawState::shown); captures and other pictures have it. */
  void SetHiddenInView(bool hidden) { this->HiddenInView = hidden; }
  bool GetHiddenInView() const { return this->HiddenInView; }
  /** Draws with a program that can leave out what stands before DrawState::cut (cutaway.h). */
  void SetCut(bool cut);

  /** The facts for which its program may be specialized, if they hold (see surface_facts.h); by default all that hold.
   * If one no longer holds, the next draw uses another program. */
  void SetRequestedFacts(boxprobe::SurfaceFacts facts) { this->Asked.tuning.facts = facts; }
  boxprobe::SurfaceFacts GetRequestedFacts() const { return this->Asked.tuning.facts; }
  /** Values that its program may have as constants while the draw's values are equal (see constants.h). If they differ,
   * and for other variants, the program with uniforms is used. Null: none. */
  void SetConstants(std::shared_ptr<const boxprobe::ConstantsPlan> plan);
  /** Did the driver refuse the program with the last constants, or was memory short? Then it is drawn without them. */
  bool GetConstantsRefused() const { return this->Last.constantsRefused; }

  /** Is the surface glass, and lit so that it can be drawn as such? */
  bool DrawsGlass() const;
  /** Is it glass that samples the frame behind it, instead of only being blended? */
  bool LooksBehind() const;
  /** Did the driver refuse the debug program? VTK's own, drawn instead, only writes the first attachment. */
  bool GetDebugRefused() const { return this->Asked.debug && this->Last.refused; }
  /** The last OpenGL program as a number; 0: none. Equal numbers mean a shared program. */
  unsigned GetProgramNumber() const { return this->Last.programNumber; }
  /** Was it drawn in the last frame? Captures and linear pictures do not count. */
  bool GetDrawnInFrame() const;

  /** To be called before `actor` is drawn: chooses the program variant by its material and the current pass, and has
   * another program built if the variant changed. */
  void Prepare(vtkActor* actor);
  /** Marks further draws of the same piece, which are not counted, until Prepare(). */
  void SetAgain() { this->Again = true; }
  /** Has the program built again. */
  void Rebuild();
  /** The same, if the last one was built while no draw of ours was in progress. */
  void RebuildIfPlain();

  ///@{
  /** VTK's interface. */
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

  /** The requested program. */
  struct Request {
    std::shared_ptr<const boxprobe::ProbeBinding> whole;    ///< as it was given
    std::shared_ptr<const boxprobe::ProbeBinding> binding;  ///< with as much as the driver links
    bool separateSpecular = false, heights = false, debug = false, cut = false;
    int objectNumber = 0;
    boxprobe::FrameParts leftOut = 0;
    boxprobe::ProgramRequest tuning;
  };
  /** What the current program is compiled for. */
  struct Variant {
    std::shared_ptr<const boxprobe::ProbeBinding> binding;  ///< the requested binding, or its cheap variant
    std::string key;                                        ///< variant key of the binding
    boxprobe::ProgramTraits traits;
    boxprobe::LightForm form = boxprobe::LightForm::Single;
    boxprobe::Tone tone = boxprobe::Tone::None;
    std::vector<int> lightPlaces;
    int glass = 0;
  };
  /** The result of building the program. */
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
  std::shared_ptr<const boxprobe::ProbeBinding> WithLess() const;
  std::shared_ptr<const boxprobe::SurfaceMaterial> WithTextureLess() const;
  bool GiveUp();
  void AskWhole();
  void TakeLess();
  void Refuse(vtkAbstractMapper* mapper, vtkActor* actor);
  void Upload(vtkShaderProgram* program, const double* boundsWorld);
  void Count(vtkShaderProgram* program);

  std::shared_ptr<boxprobe::DrawState> State;
  std::shared_ptr<const boxprobe::SurfaceMaterial> Surface;
  std::shared_ptr<const boxprobe::MirrorPicture> Mirror;
  Request Asked;
  Variant Made;
  Outcome Last;
  /** What was given up, because the driver refused the program. */
  struct Less {
    int steps = 0;             ///< of the binding
    std::size_t textures = 0;  ///< of the material
  };
  std::map<std::string, Less> LessOf;  ///< by the variant key of the whole binding; of this material and mirror alone
  std::shared_ptr<const boxprobe::SurfaceMaterial> WholeSurface;
  std::size_t TexturesLess = 0;  ///< that Surface lacks of the whole
  vtkTimeStamp Built;            ///< when the program last had to change
  bool Again = false;
  bool HiddenInView = false;
  vtkWeakPointer<vtkActor> Actor;
  vtkWeakPointer<vtkProp> Owner;
  vtkSmartPointer<vtkInformation>
      Keys;               ///< the keys that contain it: VTK 9.1 does not release it when they are discarded
  bool KeysMade = false;  ///< the owner had no keys
};
