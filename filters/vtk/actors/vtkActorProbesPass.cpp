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

}  // namespace

vtkActorProbesPass::vtkActorProbesPass() = default;
vtkActorProbesPass::~vtkActorProbesPass() = default;

void vtkActorProbesPass::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Variant: " << this->VariantKey << "\n";
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
  this->Built.Modified();
}

void vtkActorProbesPass::Attach(vtkActor* actor) {
  this->Detach();
  this->Actor = actor;
  this->KeysMade = actor->GetPropertyKeys() == nullptr;
  if (this->KeysMade) {
    vtkNew<vtkInformation> keys;
    actor->SetPropertyKeys(keys);
  }
  vtkOpenGLRenderPass::RenderPasses()->Append(actor->GetPropertyKeys(), this);
}

void vtkActorProbesPass::Detach() {
  vtkActor* actor = this->Actor;
  this->Actor = nullptr;
  vtkInformation* keys = actor != nullptr ? actor->GetPropertyKeys() : nullptr;
  if (keys == nullptr) {
    return;
  }
  auto* passes = vtkOpenGLRenderPass::RenderPasses();
  passes->Remove(keys, this);
  if (passes->Length(keys) == 0) {
    keys->Remove(passes);
  }
  if (this->KeysMade && keys->GetNumberOfKeys() == 0) {
    actor->SetPropertyKeys(nullptr);
  }
}

bool vtkActorProbesPass::PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                                 vtkAbstractMapper* mapper, vtkProp* prop) {
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!this->Draws || !this->Binding || this->Refused || actor == nullptr || this->Draws->renderer == nullptr) {
    return true;
  }
  boxprobe::FrameCounts& counts = this->Draws->state.counts;
  vtkRenderer* renderer = this->Draws->renderer;
  const bool polygons = drawsPolygonsAlone(mapper, actor);
  if (actor->GetProperty()->GetInterpolation() != VTK_PBR) {
    counts.fail(
        "an actor with probes is not shaded physically, so that it reflects nothing; call "
        "GetProperty()->SetInterpolationToPBR()");
    return true;
  }
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

bool vtkActorProbesPass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*,
                                             vtkOpenGLVertexArrayObject*) {
  if (!this->Draws || !this->Binding || this->Draws->renderer == nullptr || !program->IsUniformUsed("bpExposure")) {
    return true;
  }
  this->Draws->bound.clear();
  const boxprobe::UniformUpload to{program, this->Draws->renderer, this->Draws->bound};
  boxprobe::uploadOutput(to, this->Draws->state.pass());
  boxprobe::uploadLighting(to, this->Draws->state, *this->Binding, false,
                           boxprobe::lightingValues(this->Draws->state, *this->Binding));
  return true;
}
