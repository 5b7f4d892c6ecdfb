#include "filters/vtk/actors/vtkActorProbesPass.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLightingMapPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/gl/program_check.h"
#include "filters/vtk/surface/probe_uniforms.h"
#include "filters/vtk/surface/vtk_pbr_splice.h"

vtkStandardNewMacro(vtkActorProbesPass);

namespace {

bool anyLightOn(vtkRenderer* renderer) {
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it)) {
    if (light->GetSwitch() != 0) {
      return true;
    }
  }
  return false;
}

// Is this a program for polygons, as far as can be told from outside of the mapper? Lines and points are never lit
// physically unless they have normals, so that a text without lighting says nothing there.
bool drawsPolygonsAlone(vtkAbstractMapper* mapper, vtkActor* actor) {
  auto* polyMapper = vtkPolyDataMapper::SafeDownCast(mapper);
  vtkPolyData* data = polyMapper != nullptr ? polyMapper->GetInput() : nullptr;
  vtkInformation* keys = actor->GetPropertyKeys();
  const bool normals = keys != nullptr && keys->Has(vtkLightingMapPass::RENDER_NORMALS()) != 0;
  vtkProperty* property = actor->GetProperty();
  return data != nullptr && !normals && property->GetRepresentation() == VTK_SURFACE &&
         property->GetVertexVisibility() == 0 && data->GetNumberOfLines() == 0 && data->GetNumberOfVerts() == 0 &&
         data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
}

// What VTK writes as display colours, as the light that has that colour on the display: in captures alone.
constexpr const char* kLightOfDisplay = R"(
  if (bpLightOfDisplay > 0.0)
  {
    gl_FragData[0].rgb = bpLightOfDisplay * pow(max(gl_FragData[0].rgb, vec3(0.0)), vec3(2.2));
  }
)";

void captureAsLight(std::string& fragment) {
  const std::size_t main = fragment.find("void main()");
  const std::size_t end = fragment.rfind('}');
  if (main == std::string::npos || end == std::string::npos || end < main) {
    return;
  }
  fragment.insert(end, kLightOfDisplay);
  fragment.insert(main, "uniform float bpLightOfDisplay;\n");
}

bool isIn(vtkInformation* keys, const vtkOpenGLRenderPass* pass) {
  auto* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys != nullptr && keys->Has(passes) != 0 ? passes->Length(keys) : 0;
  for (int i = 0; i < count; ++i) {
    if (passes->Get(keys, i) == pass) {
      return true;
    }
  }
  return false;
}

}  // namespace

vtkActorProbesPass::vtkActorProbesPass() = default;
vtkActorProbesPass::~vtkActorProbesPass() = default;

void vtkActorProbesPass::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actor: " << this->Actor.GetPointer() << "\n";
  os << indent << "Owner: " << this->Owner.GetPointer() << "\n";
  os << indent << "Variant: " << this->VariantKey << "\n";
  os << indent << "Refused: " << this->Refused << "\n";
}

void vtkActorProbesPass::SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding) {
  this->Binding = std::move(binding);
  const std::string key = this->Binding ? this->Binding->variantKey() : std::string();
  if (key != this->VariantKey) {
    this->VariantKey = key;
    this->Rebuild();
  }
}

void vtkActorProbesPass::Rebuild() {
  this->Refused = false;
  this->Plain = false;
  this->Built.Modified();
}

void vtkActorProbesPass::RebuildIfPlain() {
  if (this->Plain) {
    this->Rebuild();
  }
}

void vtkActorProbesPass::Attach(vtkActor* actor, vtkProp* owner) {
  if (this->Actor == actor && this->Owner == owner && this->Keys == owner->GetPropertyKeys() &&
      isIn(this->Keys, this)) {
    return;
  }
  this->Detach();
  this->Run = false;
  this->Actor = actor;
  this->Owner = owner;
  this->KeysMade = owner->GetPropertyKeys() == nullptr;
  if (this->KeysMade) {
    vtkNew<vtkInformation> keys;
    owner->SetPropertyKeys(keys);
  }
  this->Keys = owner->GetPropertyKeys();
  vtkOpenGLRenderPass::RenderPasses()->Append(this->Keys, this);
  this->Rebuild();
}

void vtkActorProbesPass::Detach() {
  vtkProp* owner = this->Owner;
  const vtkSmartPointer<vtkInformation> keys = this->Keys;
  this->Actor = nullptr;
  this->Owner = nullptr;
  this->Keys = nullptr;
  if (keys == nullptr) {
    return;
  }
  auto* passes = vtkOpenGLRenderPass::RenderPasses();
  if (isIn(keys, this)) {
    passes->Remove(keys, this);
  }
  if (keys->Has(passes) != 0 && passes->Length(keys) == 0) {
    keys->Remove(passes);
  }
  if (this->KeysMade && owner != nullptr && owner->GetPropertyKeys() == keys && keys->GetNumberOfKeys() == 0) {
    owner->SetPropertyKeys(nullptr);
  }
}

bool vtkActorProbesPass::HasOther(vtkActor* actor, const vtkActorProbesPass* own) {
  vtkInformation* keys = actor->GetPropertyKeys();
  auto* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys != nullptr && keys->Has(passes) != 0 ? passes->Length(keys) : 0;
  for (int i = 0; i < count; ++i) {
    auto* other = vtkActorProbesPass::SafeDownCast(passes->Get(keys, i));
    if (other != nullptr && other != own && other->Actor == actor) {
      return true;
    }
  }
  return false;
}

// What an actor draws with in its own place (a level of detail) has the actor's keys.
bool vtkActorProbesPass::IsFor(vtkProp* prop) const {
  return prop == this->Actor.GetPointer() || this->Owner.GetPointer() == this->Actor.GetPointer();
}

bool vtkActorProbesPass::PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                                 vtkAbstractMapper* mapper, vtkProp* prop) {
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!this->Draws || actor == nullptr || !this->IsFor(prop)) {
    return true;
  }
  if (this->Draws->renderer == nullptr) {
    this->Plain = true;
    return true;
  }
  if (!this->Binding || this->Refused) {
    return true;
  }
  boxprobe::FrameCounts& counts = this->Draws->state.counts;
  vtkRenderer* renderer = this->Draws->renderer;
  vtkProperty* property = actor->GetProperty();
  if (property->GetInterpolation() != VTK_PBR || !property->GetLighting()) {
    captureAsLight(fragment);
    return true;
  }
  const bool polygons = drawsPolygonsAlone(mapper, actor);
  const bool light = anyLightOn(renderer);
  if (polygons && !light && !renderer->GetUseImageBasedLighting()) {
    counts.fail("VTK shades nothing physically without a light; add one to the renderer, of intensity 0 if need be");
    return true;
  }
  boxprobe::ShaderSources sources{vertex, geometry, fragment};
  boxprobe::SurfaceProgram program{*this->Binding, nullptr, boxprobe::SurfaceOutput::Picture, false};
  program.form = this->Draws->state.resources.lightForm;
  program.foreign = true;
  program.emission = this->Draws->emission;
  const boxprobe::SpliceReport report = boxprobe::splicePbr(sources, program, polygons && light);
  counts.fail(report.failure);
  if (!report.needed || !report.failure.empty()) {
    captureAsLight(fragment);
    return true;
  }
  boxprobe::breakShaderIfAsked(sources.fragment, "surface");
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!boxprobe::programCompiles(window, sources.vertex, sources.geometry, sources.fragment)) {
    counts.fail(boxprobe::kSurfaceRefused);
    this->Refused = true;
    return true;
  }
  vertex = sources.vertex;
  geometry = sources.geometry;
  fragment = sources.fragment;
  return true;
}

bool vtkActorProbesPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop,
                                             vtkOpenGLVertexArrayObject*) {
  if (!this->Draws || !this->IsFor(prop)) {
    return true;
  }
  this->Run = true;
  if (program->IsUniformUsed("bpLightOfDisplay")) {
    const bool capturing = this->Draws->state.pass().exposure == boxprobe::kLinearOutput;
    program->SetUniformf("bpLightOfDisplay", capturing ? static_cast<float>(1.0 / this->Draws->exposure) : 0.0f);
  }
  if (!this->Binding || this->Draws->renderer == nullptr || !program->IsUniformUsed("bpExposure")) {
    return true;
  }
  this->Draws->bound.clear();
  const boxprobe::UniformUpload to{program, this->Draws->renderer, this->Draws->bound};
  boxprobe::uploadOutput(to, this->Draws->state.pass());
  boxprobe::uploadLighting(to, this->Draws->state, *this->Binding, false,
                           boxprobe::lightingValues(this->Draws->state, *this->Binding));
  return true;
}
