#include "filters/vtk/surface/vtkProbePolyDataMapper.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLightingMapPass.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>

#include "filters/vtk/draw/plain_surface.h"
#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/gl/program_check.h"
#include "filters/vtk/surface/glass_draw.h"
#include "filters/vtk/surface/probe_uniforms.h"
#include "filters/vtk/surface/resting_uniforms.h"
#include "filters/vtk/surface/surface_uniforms.h"
#include "filters/vtk/surface/view_uniforms.h"
#include "filters/vtk/surface/vtk_pbr_splice.h"

using boxprobe::Lighting;

vtkStandardNewMacro(vtkProbePolyDataMapper);

vtkProbePolyDataMapper::vtkProbePolyDataMapper() = default;
vtkProbePolyDataMapper::~vtkProbePolyDataMapper() = default;

void vtkProbePolyDataMapper::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Variant: " << this->VariantKey << "\n";
}

void vtkProbePolyDataMapper::SetDrawState(std::shared_ptr<boxprobe::DrawState> state) {
  this->State = std::move(state);
}

void vtkProbePolyDataMapper::SetSurface(std::shared_ptr<const boxprobe::SurfaceMaterial> surface) {
  this->Surface = std::move(surface);
  this->RemoveAllVertexAttributeMappings();
  const auto map = [this](bool wanted, const char* name) {
    if (wanted) {
      this->MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    }
  };
  if (this->Surface) {
    map(this->Surface->uv[0], "bpUv0");
    map(this->Surface->uv[1], "bpUv1");
    map(this->Surface->colors, "bpColor");
    map(this->Surface->tangents, "bpTangent");
  }
  this->Modified();
}

void vtkProbePolyDataMapper::SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding) {
  this->Binding = std::move(binding);
  this->UpdateDrawn();
}

void vtkProbePolyDataMapper::SetStandIn(bool standIn) {
  if (standIn != this->StandIn) {
    this->StandIn = standIn;
    this->UpdateDrawn();
  }
}

void vtkProbePolyDataMapper::UpdateDrawn() {
  this->Drawn = this->StandIn && this->Binding ? this->Binding->standIn() : nullptr;
  if (!this->Drawn) {
    this->Drawn = this->Binding;
  }
  if (this->Dark && this->Drawn != this->DarkOf) {
    this->Dark = this->DarkOf = nullptr;
    this->Modified();
  }
  const std::string key = this->Drawn ? this->Drawn->variantKey() : std::string();
  if (key != this->VariantKey) {
    this->VariantKey = key;
    this->Refused = false;
    this->Modified();
  }
}

void vtkProbePolyDataMapper::SetSeparateSpecular(bool apart) {
  if (apart != this->SeparateSpecular) {
    this->SeparateSpecular = apart;
    this->Refused = false;
    this->Modified();
  }
}

bool vtkProbePolyDataMapper::DrawsGlass() const {
  return this->State && this->Surface && this->Surface->glass.drawn && this->Drawn &&
         this->Drawn->lighting == Lighting::Probes && !this->Refused;
}

bool vtkProbePolyDataMapper::LooksBehind() const {
  return this->DrawsGlass() &&
         this->Surface->glass.looksBehind(this->Surface->slots[boxprobe::kRoughMetalSlot].texture != nullptr);
}

void vtkProbePolyDataMapper::SetHeights(bool heights) {
  if (heights != this->Heights) {
    this->Heights = heights;
    this->Refused = false;
    this->Modified();
  }
}

void vtkProbePolyDataMapper::SetMirror(std::shared_ptr<const boxprobe::MirrorPicture> mirror) {
  const bool another = (mirror == nullptr) != (this->Mirror == nullptr);
  this->Mirror = std::move(mirror);
  if (another) {
    this->Refused = false;
    this->Modified();
  }
}

bool vtkProbePolyDataMapper::GetDrawnInFrame() const {
  return this->State && this->Frame + 1 == this->State->counts.counters.renders;
}

void vtkProbePolyDataMapper::SetDebug(bool debug) {
  if (debug != this->Debug) {
    this->Debug = debug;
    this->Refused = false;
    this->Modified();
  }
}

// A program that does not compile takes VTK 9.1 down where it is used next, so it is tried here: the cache then has it
// ready, at no further cost. In place of one that the driver refuses comes VTK's own: an object without reflections is
// better than none.
void vtkProbePolyDataMapper::BuildShaders(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                                          vtkActor* actor) {
  this->Superclass::BuildShaders(shaders, renderer, actor);
  if (!this->State || !this->Drawn || this->Refused) {
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto source = [&](vtkShader::Type type) { return shaders[type]->GetSource(); };
  if (boxprobe::programCompiles(window, source(vtkShader::Vertex), source(vtkShader::Geometry),
                                source(vtkShader::Fragment))) {
    return;
  }
  if (this->Constants) {
    this->Constants = nullptr;
    this->ConstantsRefused = true;
    this->Superclass::BuildShaders(shaders, renderer, actor);
    // As a rule the same with uniforms has been drawn before, but facts may have changed with the constants.
    if (boxprobe::programCompiles(window, source(vtkShader::Vertex), source(vtkShader::Geometry),
                                  source(vtkShader::Fragment))) {
      return;
    }
  }
  this->Refused = true;
  this->Superclass::BuildShaders(shaders, renderer, actor);
  if (this->Debug) {
    return;  // whoever asked for the view is told by GetDebugRefused(); the picture's own program is another one
  }
  this->State->counts.fail(boxprobe::kSurfaceRefused);
  if (this->Surface) {
    // From the next frame on: this one's program has been chosen.
    boxprobe::givePlainSurface(*this->Surface, actor->GetProperty(), this->CurrentInput);
  }
}

// As VTK decides it for the primitives at hand: none for lines without normals, nor for passes that draw normals.
bool vtkProbePolyDataMapper::LitPhysically(vtkActor* actor) {
  vtkInformation* keys = actor->GetPropertyKeys();
  return actor->GetProperty()->GetInterpolation() == VTK_PBR &&
         static_cast<int>(this->PrimitiveInfo[this->LastBoundBO].LastLightComplexity) > 0 &&
         (keys == nullptr || keys->Has(vtkLightingMapPass::RENDER_NORMALS()) == 0);
}

void vtkProbePolyDataMapper::ReplaceShaderValues(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                                                 vtkActor* actor) {
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  if (!this->State || !this->Drawn || this->Refused) {
    return;
  }
  boxprobe::ShaderSources sources;
  sources.vertex = shaders[vtkShader::Vertex]->GetSource();
  sources.geometry = shaders[vtkShader::Geometry]->GetSource();
  sources.fragment = shaders[vtkShader::Fragment]->GetSource();
  using boxprobe::SurfaceOutput;
  const bool blended = actor->HasTranslucentPolygonalGeometry() != 0 || this->DrawsGlass();
  const bool samples = this->Drawn->blurredSamples() > 0 && !blended;
  const SurfaceOutput output = this->Debug               ? SurfaceOutput::Debug
                               : this->Heights           ? SurfaceOutput::Heights
                               : !this->SeparateSpecular ? SurfaceOutput::Picture
                               : samples                 ? SurfaceOutput::SpecularSeparate
                                                         : SurfaceOutput::SpecularSeparateNone;
  boxprobe::SurfaceProgram program{this->Made(), this->Surface.get(), output, this->Mirror != nullptr,
                                   this->Form,   this->Facts};
  program.flatMaps = this->DrawsFlat();
  const boxprobe::SpliceReport report = boxprobe::splicePbr(sources, program, this->LitPhysically(actor));
  this->State->counts.fail(report.failure);
  boxprobe::breakShaderIfAsked(sources.fragment, this->Debug ? "debug" : "surface");
  if (this->Constants) {
    boxprobe::foldConstants(sources.fragment, this->Constants->values);
    boxprobe::breakShaderIfAsked(sources.fragment, "constants");
  }
  boxprobe::leaveOut(sources.fragment, this->LeftOut);
  shaders[vtkShader::Vertex]->SetSource(sources.vertex);
  shaders[vtkShader::Geometry]->SetSource(sources.geometry);
  shaders[vtkShader::Fragment]->SetSource(sources.fragment);
}

// The debug view shows what the calculation finds, all of it.
boxprobe::SurfaceFacts vtkProbePolyDataMapper::FactsOf(vtkActor* actor) {
  if (!this->State || this->State->resources.general || !this->Surface || this->Debug) {
    return 0;
  }
  return this->Foldable & boxprobe::surfaceFacts(*this->Surface, actor->GetProperty());
}

void vtkProbePolyDataMapper::SetConstants(std::shared_ptr<const boxprobe::ConstantsPlan> plan) {
  this->Plan = std::move(plan);
  this->ConstantsRefused = false;
}

void vtkProbePolyDataMapper::SetLeftOut(boxprobe::FrameParts parts) {
  constexpr boxprobe::FrameParts written = ~(boxprobe::kRasterPart | boxprobe::kObjectPart);
  const bool another = (parts & written) != (this->LeftOut & written);
  this->LeftOut = parts;
  if (another) {
    this->Modified();
  }
}

boxprobe::RestingValues vtkProbePolyDataMapper::GetRestingValues(vtkActor* actor) const {
  boxprobe::RestingValues values;
  if (this->State && this->Drawn) {
    values = boxprobe::lightingValues(*this->State, *this->Drawn);
  }
  if (this->Surface) {
    values.add(boxprobe::materialValues(*this->Surface, actor->GetProperty()));
  }
  return values;
}

// Whether the constants still hold is asked of the numbers themselves, so that no edit has to tell.
void vtkProbePolyDataMapper::ChooseConstants(vtkActor* actor) {
  std::shared_ptr<const boxprobe::ConstantsPlan> constants;
  if (this->Plan && this->State && this->Drawn && !this->Dark && !this->Refused && !this->State->resources.general &&
      !this->ConstantsRefused && !this->Debug && !this->Heights && this->Plan->variant == this->VariantKey) {
    if (this->GetRestingValues(actor).hold(this->Plan->values)) {
      constants = this->Plan;
    }
  }
  if (constants != this->Constants) {
    if (!constants && this->State->pass().countDraws && !this->State->resources.general) {
      ++this->State->counts.counters.constantsLeft;
    }
    this->Constants = std::move(constants);
    this->Modified();
  }
  const bool flat = this->Constants && boxprobe::makeFlatMaps(*this->State, *this->Drawn);
  if (flat != this->FlatMaps) {
    this->FlatMaps = flat;
    this->Modified();
  }
}

// A mirror's picture and glass look up more than probes.
void vtkProbePolyDataMapper::ChooseDark() {
  const bool wanted = this->State && this->Drawn && this->State->pass().firstBounce && this->State->pass().dark &&
                      !this->State->resources.general && !this->Debug && !this->Heights && !this->Mirror &&
                      !this->DrawsGlass();
  if (wanted && this->DarkOf == this->Drawn) {
    return;
  }
  const bool before = this->Dark != nullptr;
  this->Dark = wanted ? this->Drawn->inTheDark() : nullptr;
  this->DarkOf = wanted ? this->Drawn : nullptr;
  if (before || this->Dark) {
    this->Modified();
  }
}

void vtkProbePolyDataMapper::UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) {
  const int glass = this->DrawsGlass() ? this->Surface->glass.variant() : 0;
  if (glass != this->GlassVariant) {
    this->GlassVariant = glass;
    this->Modified();
  }
  if (this->State && this->State->resources.lightForm != this->Form) {
    this->Form = this->State->resources.lightForm;
    this->Refused = false;
    this->Modified();
  }
  const boxprobe::SurfaceFacts facts = this->FactsOf(actor);
  if (facts != this->Facts) {
    this->Facts = facts;
    this->Refused = false;
    this->Modified();
  }
  this->ChooseDark();
  this->ChooseConstants(actor);
  // Given back since it was drawn last (see program_shelf.h): made again, with its attributes.
  if (cellBO.Program != nullptr && !cellBO.Program->GetCompiled()) {
    cellBO.Program = nullptr;
  }
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
  if (!this->State) {
    return;
  }
  if (this->Dark) {
    ++this->State->counts.counters.objectsUnlit;
  }
  if (cellBO.Program != nullptr && this->State->programs.use(cellBO.Program, this->Constants != nullptr)) {
    ++this->State->counts.counters.programsCompiled;
  }
}

void vtkProbePolyDataMapper::SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer,
                                                       vtkActor* actor) {
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  vtkShaderProgram* program = cellBO.Program;
  if (!this->State || !this->Drawn || !program->IsUniformUsed("bpExposure")) {
    return;
  }
  const boxprobe::UniformUpload to{program, renderer, this->Bound};
  boxprobe::uploadOutput(to, this->State->pass());
  if (this->Surface) {
    boxprobe::uploadMaterial(to, *this->Surface);
  }
  const bool probes = this->Drawn->lighting == Lighting::Probes;
  if (probes) {
    this->UploadLighting(to);
  } else if (this->Form == boxprobe::LightForm::Multiple) {
    boxprobe::uploadSplitSum(to, this->State->resources);
  }
  if (this->Heights) {
    program->SetUniform4f("bpHeightPlane", &this->State->pass().heightPlaneView.x);
  }
  if (this->Debug) {
    boxprobe::uploadView(to, *this->State, *this->Drawn, this->ObjectNumber);
  }
  if (this->State->pass().countDraws && !this->Again) {
    this->ProgramNumber = static_cast<unsigned>(program->GetHandle());
    this->Frame = this->State->counts.counters.renders;
    this->State->counts.draws(program);
    ++this->State->counts.counters.drawsByProbeCount[probes ? this->Drawn->probes.size() : 0];
    this->State->counts.counters.drawsWithCoverage += probes && !this->Drawn->shadowLights.empty() ? 1 : 0;
    this->State->counts.counters.drawsWithOpenSky += probes && this->Drawn->open() ? 1 : 0;
  }
}

void vtkProbePolyDataMapper::UploadLighting(const boxprobe::UniformUpload& to) {
  boxprobe::DrawState& state = *this->State;
  boxprobe::uploadLighting(to, state, this->Made(), this->Debug, boxprobe::lightingValues(state, this->Made()),
                           this->Constants ? &this->Constants->values : nullptr, this->DrawsFlat());
  if (this->Mirror) {
    boxprobe::uploadMirror(to, *this->Mirror, state.resources);
  }
  if (this->DrawsGlass()) {
    boxprobe::uploadGlassOf(to, this->Surface->glass, *this->Drawn, state.resources, state.pass().behind);
  }
}

void vtkProbePolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  if ((this->LeftOut & (boxprobe::kRasterPart | boxprobe::kObjectPart)) != 0) {
    if ((this->LeftOut & boxprobe::kObjectPart) != 0) {
      return;
    }
    glEnable(GL_RASTERIZER_DISCARD);
    this->Superclass::RenderPieceDraw(renderer, actor);
    glDisable(GL_RASTERIZER_DISCARD);
    return;
  }
  if (!this->DrawsGlass() || renderer->GetSelector() != nullptr) {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int passes = boxprobe::drawGlassPasses(window->GetState(), this->Surface->glass, [&](bool) {
    this->Bound.clear();
    this->Superclass::RenderPieceDraw(renderer, actor);
    this->Again = true;
  });
  this->Again = false;
  if (this->State->pass().countDraws) {
    ++this->State->counts.counters.glassDraws;
    this->State->counts.counters.glassPasses += static_cast<std::uint64_t>(passes);
  }
}

void vtkProbePolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::RenderPieceFinish(renderer, actor);
  this->Bound.clear();
}
