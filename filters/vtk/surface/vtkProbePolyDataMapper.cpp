#include "filters/vtk/surface/vtkProbePolyDataMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLightingMapPass.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>

#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/surface/coverage_uniforms.h"
#include "filters/vtk/surface/glass_draw.h"
#include "filters/vtk/surface/plain_surface.h"
#include "filters/vtk/surface/probe_uniforms.h"
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
  // Copies: the cache finishes the sources it is given.
  std::map<vtkShader::Type, vtkSmartPointer<vtkShader>> copies;
  std::map<vtkShader::Type, vtkShader*> tried;
  for (const auto& entry : shaders) {
    auto copy = vtkSmartPointer<vtkShader>::New();
    copy->SetType(entry.first);
    copy->SetSource(entry.second->GetSource());
    tried[entry.first] = copy;
    copies[entry.first] = copy;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(tried);
  if (program != nullptr && program->GetCompiled()) {
    return;
  }
  this->State->counts.fail(
      "this OpenGL driver refuses the shader of a surface with probes; it is drawn without reflections");
  this->Refused = true;
  this->Superclass::BuildShaders(shaders, renderer, actor);
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
  const boxprobe::SurfaceProgram program{*this->Drawn, this->Surface.get(), output, this->Mirror != nullptr,
                                         this->Form};
  const boxprobe::SpliceReport report = boxprobe::splicePbr(sources, program, this->LitPhysically(actor));
  this->State->counts.fail(report.failure);
  boxprobe::breakShaderIfAsked(sources.fragment, "surface");
  shaders[vtkShader::Vertex]->SetSource(sources.vertex);
  shaders[vtkShader::Geometry]->SetSource(sources.geometry);
  shaders[vtkShader::Fragment]->SetSource(sources.fragment);
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
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
  if (!this->State) {
    return;
  }
  if (cellBO.Program != nullptr && this->State->counts.programs.insert(cellBO.Program).second) {
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
  program->SetUniformf("bpExposure", this->State->pass().exposure);
  program->SetUniformf("bpParallel", renderer->GetActiveCamera()->GetParallelProjection() ? 1.0f : 0.0f);
  const boxprobe::UniformUpload to{program, renderer, this->Bound};
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
    this->Frame = this->State->counts.counters.renders;
    ++this->State->counts.counters.drawsByProbeCount[probes ? this->Drawn->probes.size() : 0];
    this->State->counts.counters.drawsWithCoverage += probes && !this->Drawn->shadowLights.empty() ? 1 : 0;
    this->State->counts.counters.drawsWithOpenSky += probes && this->Drawn->open() ? 1 : 0;
  }
}

void vtkProbePolyDataMapper::UploadLighting(const boxprobe::UniformUpload& to) {
  boxprobe::DrawState& state = *this->State;
  ++state.counts.counters.uniformUpdates;
  boxprobe::uploadSurroundings(to, state.resources, *this->Drawn);
  if (this->Mirror) {
    boxprobe::uploadMirror(to, *this->Mirror, state.resources);
  }
  if (!this->Drawn->probes.empty()) {
    boxprobe::uploadSlots(to, state, *this->Drawn, this->Debug);
  }
  if (!this->Drawn->shadowLights.empty()) {
    boxprobe::uploadCoverage(to, state, *this->Drawn);
  }
  if (this->DrawsGlass()) {
    boxprobe::uploadGlassOf(to, this->Surface->glass, *this->Drawn, state.resources);
  }
}

void vtkProbePolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
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
