/**
 * @class   vtkProbePolyDataMapper
 * @brief   polydata mapper whose physically based shading is lit by reflection probes
 *
 * Draws as vtkOpenGLPolyDataMapper does, with probe lighting spliced into the shader (see vtk_pbr_splice.h) and its
 * uniforms uploaded at every draw, relative to the camera, from double. Give it a draw state and a binding; without a
 * binding it is VTK's own mapper.
 */
#pragma once

#include <vtkOpenGLPolyDataMapper.h>

#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/frame_parts.h"
#include "filters/vtk/draw/light_form.h"
#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/resting_values.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/draw/surface_material.h"
#include "filters/vtk/surface/uniform_upload.h"

class vtkProbePolyDataMapper : public vtkOpenGLPolyDataMapper {
 public:
  static vtkProbePolyDataMapper* New();
  vtkTypeMacro(vtkProbePolyDataMapper, vtkOpenGLPolyDataMapper) void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetDrawState(std::shared_ptr<boxprobe::DrawState> state);
  /** The material's textures and what the vertices bring, before the first draw; none: VTK's own material code. */
  void SetSurface(std::shared_ptr<const boxprobe::SurfaceMaterial> surface);
  const boxprobe::SurfaceMaterial* GetSurface() const { return this->Surface.get(); }
  /** Is the surface glass, and lit so that it can be drawn as such? */
  bool DrawsGlass() const;
  /** Glass that what is drawn behind does not already show through by blending. */
  bool LooksBehind() const;
  /** Another variant key means another program, built at the next draw; otherwise only uniforms change. */
  void SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding);
  /** Draws by what stands in for the binding's techniques (see EvaluationRow), which the binding itself keeps. */
  void SetStandIn(bool standIn);
  /** Keeps what techniques sample apart from the rest, in further attachments (see reflection_apart.glsl). */
  void SetSeparateSpecular(bool apart);
  bool GetSeparateSpecular() const { return this->SeparateSpecular; }
  /** Writes colour and height over a planar mirror, for the mirror's picture (see mirrored_output.glsl). */
  void SetHeights(bool heights);
  /** The surface is a planar mirror and looks that picture up where it is shown; null: it is none. */
  void SetMirror(std::shared_ptr<const boxprobe::MirrorPicture> mirror);
  std::shared_ptr<const boxprobe::MirrorPicture> GetMirror() const { return this->Mirror; }
  /** The binding as it is drawn. */
  const boxprobe::ProbeBinding* GetDrawnBinding() const { return this->Drawn.get(); }
  const boxprobe::ProbeBinding* GetBinding() const { return this->Binding.get(); }
  std::shared_ptr<const boxprobe::ProbeBinding> GetSharedBinding() const { return this->Binding; }
  /** What its program may take for granted, as far as it holds (see surface_facts.h); by default whatever holds. A
   * material that no longer has what its program is made for gets another program at the next draw. */
  void SetFoldableFacts(boxprobe::SurfaceFacts facts) { this->Foldable = facts; }
  boxprobe::SurfaceFacts GetFoldableFacts() const { return this->Foldable; }
  /** Numbers its program may have as constants, as long as the draw's own are the same (see resting_values.h): where
   * they differ, or for any other variant, it is drawn by the program that has them as uniforms. Null: none. */
  void SetConstants(std::shared_ptr<const boxprobe::ConstantsPlan> plan);
  /** Did the driver, or the memory, refuse the program with the constants set last? It is drawn without them. */
  bool GetConstantsRefused() const { return this->ConstantsRefused; }
  /** The driver refused the debug program, and VTK's own was drawn: it writes the first attachment alone. */
  bool GetDebugRefused() const { return this->Debug && this->Refused; }
  /** To find what they cost: the picture is drawn without these parts, which makes it a wrong one (frame_parts.h). */
  void SetLeftOut(boxprobe::FrameParts parts);
  /** The OpenGL program it was drawn with last, as a number; 0: none. Equal numbers share one. */
  unsigned GetProgramNumber() const { return this->ProgramNumber; }
  /** What the draw reads that rests between edits: lighting, then material. `actor` draws with this mapper. */
  boxprobe::RestingValues GetRestingValues(vtkActor* actor) const;
  /** Draws with the debug view's program (see vtk_pbr_splice.h) instead of the picture's. */
  void SetDebug(bool debug);
  /** Was it drawn by the frame that ended last? Captures and linear pictures do not count. */
  bool GetDrawnInFrame() const;
  /** What a surface capture names this object by; 0 is the background's. */
  void SetObjectNumber(int number) { this->ObjectNumber = number; }

 protected:
  vtkProbePolyDataMapper();
  ~vtkProbePolyDataMapper() override;

  void BuildShaders(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override;
  void UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;

 private:
  vtkProbePolyDataMapper(const vtkProbePolyDataMapper&) = delete;
  void operator=(const vtkProbePolyDataMapper&) = delete;

  bool LitPhysically(vtkActor* actor);
  boxprobe::SurfaceFacts FactsOf(vtkActor* actor);
  void UploadLighting(const boxprobe::UniformUpload& to);
  void ChooseConstants(vtkActor* actor);
  void ChooseDark();
  /** Does its program look maps up in flat pictures? One with constants may. */
  bool DrawsFlat() const { return this->Constants && this->FlatMaps; }
  /** What the program and its uniforms are made for now. */
  const boxprobe::ProbeBinding& Made() const { return this->Dark ? *this->Dark : *this->Drawn; }

  std::shared_ptr<boxprobe::DrawState> State;
  void UpdateDrawn();

  std::shared_ptr<const boxprobe::SurfaceMaterial> Surface;
  std::shared_ptr<const boxprobe::ProbeBinding> Binding;
  std::shared_ptr<const boxprobe::ProbeBinding> Drawn;
  std::shared_ptr<const boxprobe::ProbeBinding> Dark;    // in place of Drawn, while captures show no reflection
  std::shared_ptr<const boxprobe::ProbeBinding> DarkOf;  // what it was made from
  bool StandIn = false;
  bool SeparateSpecular = false;
  bool Heights = false;
  std::shared_ptr<const boxprobe::MirrorPicture> Mirror;
  std::string VariantKey;
  int GlassVariant = 0;                                    // the program's
  boxprobe::LightForm Form = boxprobe::LightForm::Single;  // the program's
  boxprobe::SurfaceFacts Foldable = boxprobe::kAnyFact;
  boxprobe::SurfaceFacts Facts = 0;                          // the program's
  std::shared_ptr<const boxprobe::ConstantsPlan> Plan;       // may be drawn with
  std::shared_ptr<const boxprobe::ConstantsPlan> Constants;  // the program's
  bool ConstantsRefused = false;
  bool FlatMaps = false;  // of the last draw
  boxprobe::FrameParts LeftOut = 0;
  unsigned ProgramNumber = 0;
  bool Again = false;  // a further pass of the same piece
  bool Debug = false;
  bool Refused = false;  // the driver did not compile the spliced program: VTK's own is drawn
  int ObjectNumber = 0;
  std::uint64_t Frame = ~std::uint64_t{0};                     // the last one that drew it
  std::vector<std::unique_ptr<boxprobe::BoundTexture>> Bound;  // for the piece being drawn
};
