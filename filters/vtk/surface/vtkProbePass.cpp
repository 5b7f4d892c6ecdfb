#include "filters/vtk/surface/vtkProbePass.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationObjectBaseVectorKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLightingMapPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderProperty.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include "filters/math/shared/shader_source.h"
#include "filters/vtk/draw/fewer_samplers.h"
#include "filters/vtk/draw/plain_surface.h"
#include "filters/vtk/draw/probe_lamps.h"
#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/gl/program_check.h"
#include "filters/vtk/surface/anchor_edits.h"
#include "filters/vtk/surface/cutaway.h"
#include "filters/vtk/surface/probe_uniforms.h"
#include "filters/vtk/surface/vtk_pbr_splice.h"

using boxprobe::Lighting;

vtkStandardNewMacro(vtkProbePass);

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

// Is this a program for polygons only, as far as can be told from outside the mapper? Lines and points have no
// physically based lighting without normals, so a missing anchor would not be an error for them.
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

// Converts the display colours that VTK writes to linear light, for captures.
constexpr const char* kLightOfDisplay = R"(
  if (bpLightOfDisplay > 0.0)
  {
    vec3 bpShown = max(gl_FragData[0].rgb, vec3(0.0));
    gl_FragData[0].rgb = bpLightOfDisplay * BP_DECODED;
  }
)";

/// Returns the failure, or nothing.
std::string captureAsLight(std::string& fragment, boxprobe::Tone tone) {
  const bool asVtk = tone == boxprobe::Tone::AsVtk;
  boxprobe::AnchorEdits edits;
  edits.insertAtMain(fragment, "light of display colours",
                     std::string("uniform float bpLightOfDisplay;\n#define BP_DECODED ") +
                         (asVtk ? "pow(bpShown, vec3(2.2))\n" : "srgbDecoded(bpShown)\n") +
                         std::string(boxprobe::shaderSource("shared/display.glsl")));
  if (edits.failure().empty()) {
    fragment.insert(fragment.rfind('}'), kLightOfDisplay);
  }
  return boxprobe::spliceFailure(edits);
}

int countOfPasses(vtkInformation* keys) {
  auto* passes = vtkOpenGLRenderPass::RenderPasses();
  return keys != nullptr && keys->Has(passes) != 0 ? passes->Length(keys) : 0;
}

vtkOpenGLRenderPass* passAt(vtkInformation* keys, int index) {
  return static_cast<vtkOpenGLRenderPass*>(vtkOpenGLRenderPass::RenderPasses()->Get(keys, index));
}

bool isIn(vtkInformation* keys, const vtkOpenGLRenderPass* pass) {
  for (int i = 0; i < countOfPasses(keys); ++i) {
    if (passAt(keys, i) == pass) {
      return true;
    }
  }
  return false;
}

}  // namespace

vtkProbePass::vtkProbePass() = default;
vtkProbePass::~vtkProbePass() = default;

void vtkProbePass::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actor: " << this->Actor.GetPointer() << "\n";
  os << indent << "Owner: " << this->Owner.GetPointer() << "\n";
  os << indent << "Variant: " << this->Made.key << "\n";
  os << indent << "Refused: " << this->Last.refused << "\n";
}

void vtkProbePass::Attach(vtkActor* actor, vtkProp* owner) {
  if (this->Actor == actor && this->Owner == owner && this->Keys == owner->GetPropertyKeys() &&
      isIn(this->Keys, this)) {
    return;
  }
  this->Detach();
  this->Last.run = false;
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

void vtkProbePass::Detach() {
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

bool vtkProbePass::HasOther(vtkActor* actor, const vtkProbePass* own) {
  vtkInformation* keys = actor->GetPropertyKeys();
  for (int i = 0; i < countOfPasses(keys); ++i) {
    auto* other = vtkProbePass::SafeDownCast(passAt(keys, i));
    if (other != nullptr && other != own && other->Actor == actor) {
      return true;
    }
  }
  return false;
}

// A prop drawn in place of an actor (a level of detail) has the actor's keys.
bool vtkProbePass::IsFor(vtkProp* prop) const {
  return prop == this->Actor.GetPointer() || this->Owner.GetPointer() == this->Actor.GetPointer();
}

void vtkProbePass::SetSurface(std::shared_ptr<const boxprobe::SurfaceMaterial> surface) {
  this->WholeSurface = std::move(surface);
  this->AskWhole();
  this->Built.Modified();
}

// With another material or mirror less may have to be given up, or more.
void vtkProbePass::AskWhole() {
  this->LessOf.clear();
  this->TakeLess();
  this->UpdateDrawn();
}

// Of what is whole, as much as the driver is known to link.
void vtkProbePass::TakeLess() {
  this->Asked.binding = this->Asked.whole;
  Less less;
  if (this->Asked.whole && !this->LessOf.empty()) {
    const auto known = this->LessOf.find(this->Asked.whole->variantKey());
    if (known != this->LessOf.end()) {
      less = known->second;
    }
  }
  for (int i = 0; i < less.steps; ++i) {
    if (auto fewer = boxprobe::withLess(*this->Asked.binding)) {
      this->Asked.binding = std::move(fewer);
    }
  }
  if (less.textures == this->TexturesLess && (this->TexturesLess > 0 || this->Surface == this->WholeSurface)) {
    return;
  }
  this->Surface = this->WholeSurface;
  for (this->TexturesLess = 0; this->TexturesLess < less.textures && this->Surface; ++this->TexturesLess) {
    if (auto fewer = boxprobe::withTextureLess(*this->Surface)) {
      this->Surface = std::move(fewer);
    }
  }
  this->Built.Modified();
}

void vtkProbePass::SetBinding(std::shared_ptr<const boxprobe::ProbeBinding> binding) {
  this->Asked.whole = std::move(binding);
  this->TakeLess();
  this->UpdateDrawn();
}

void vtkProbePass::SetStandIn(bool standIn) {
  if (standIn != this->Asked.tuning.standIn) {
    this->Asked.tuning.standIn = standIn;
    this->UpdateDrawn();
  }
}

void vtkProbePass::SetRefined(boxprobe::RefinedRays rays) {
  if (!(rays == this->Asked.tuning.refined)) {
    this->Asked.tuning.refined = rays;
    this->UpdateDrawn();
  }
}

void vtkProbePass::UpdateDrawn() {
  Variant& made = this->Made;
  const boxprobe::RefinedRays rays = this->Asked.tuning.refined;
  made.binding = nullptr;
  if (this->Asked.binding && this->Asked.tuning.standIn) {
    made.binding = this->Asked.binding->standIn();
  } else if (this->Asked.binding && rays.aFrame > 0) {
    made.binding = this->Asked.binding->refined(rays.aFrame, rays.inAll);
  }
  if (!made.binding) {
    made.binding = this->Asked.binding;
  }
  if (made.traits.firstBounce && made.binding != made.traits.firstBounceOf) {
    made.traits.firstBounce = made.traits.firstBounceOf = nullptr;
    this->Built.Modified();
  }
  std::string key = made.binding ? made.binding->variantKey() : std::string();
  if (key != made.key) {
    made.key = std::move(key);
    this->Rebuild();
  }
}

void vtkProbePass::SetSeparateSpecular(bool apart) {
  if (apart != this->Asked.separateSpecular) {
    this->Asked.separateSpecular = apart;
    this->Rebuild();
  }
}

void vtkProbePass::SetHeights(bool heights) {
  if (heights != this->Asked.heights) {
    this->Asked.heights = heights;
    this->Rebuild();
  }
}

void vtkProbePass::SetMirror(std::shared_ptr<const boxprobe::MirrorPicture> mirror) {
  const bool another = (mirror == nullptr) != (this->Mirror == nullptr);
  this->Mirror = std::move(mirror);
  if (another) {
    this->AskWhole();
    this->Rebuild();
  }
}

void vtkProbePass::SetDebug(bool debug) {
  if (debug != this->Asked.debug) {
    this->Asked.debug = debug;
    this->Rebuild();
  }
}

void vtkProbePass::SetCut(bool cut) {
  if (cut != this->Asked.cut) {
    this->Asked.cut = cut;
    this->Rebuild();
  }
}

void vtkProbePass::SetDisabledParts(boxprobe::FrameParts parts) {
  constexpr boxprobe::FrameParts written = ~(boxprobe::kRasterPart | boxprobe::kObjectPart | boxprobe::kGroundPart);
  const bool another = (parts & written) != (this->Asked.leftOut & written);
  this->Asked.leftOut = parts;
  if (another) {
    this->Built.Modified();
  }
}

void vtkProbePass::SetConstants(std::shared_ptr<const boxprobe::ConstantsPlan> plan) {
  this->Asked.tuning.constants = std::move(plan);
  this->Last.constantsRefused = false;
}

bool vtkProbePass::DrawsGlass() const {
  return this->State && this->Surface && this->Surface->glass.drawn && this->Made.binding &&
         this->Made.binding->lighting == Lighting::Probes && !this->Last.refused;
}

bool vtkProbePass::LooksBehind() const {
  return this->DrawsGlass() &&
         this->Surface->glass.looksBehind(this->Surface->slots[boxprobe::kRoughMetalSlot].texture != nullptr);
}

bool vtkProbePass::GetDrawnInFrame() const {
  return this->State && this->Last.frame + 1 == this->State->counts.counters.renders;
}

void vtkProbePass::Rebuild() {
  this->Last.refused = false;
  this->Last.plain = false;
  this->Built.Modified();
}

void vtkProbePass::RebuildIfPlain() {
  if (this->Last.plain) {
    this->Rebuild();
  }
}

void vtkProbePass::Prepare(vtkActor* actor) {
  this->Again = false;
  if (!this->State) {
    return;
  }
  const int glass = this->DrawsGlass() ? this->Surface->glass.variant() : 0;
  if (glass != this->Made.glass) {
    this->Made.glass = glass;
    this->Built.Modified();
  }
  const boxprobe::SceneResources& resources = this->State->resources;
  if (resources.lightForm != this->Made.form || resources.tone != this->Made.tone ||
      resources.lightPlaces != this->Made.lightPlaces) {
    this->Made.form = resources.lightForm;
    this->Made.tone = resources.tone;
    this->Made.lightPlaces = resources.lightPlaces;
    this->Rebuild();
  }
  if (this->Made.binding) {
    boxprobe::makeLampFree(*this->State, *this->Made.binding);
  }
  this->ChooseTraits(actor);
  // Released since the last draw: rebuilt with its attributes.
  if (this->Last.program != nullptr && this->State->tuning != nullptr &&
      this->State->tuning->compilation(this->Last.program) != this->Last.compilation) {
    this->Last.program = nullptr;
    this->Built.Modified();
  }
}

// The debug view shows the complete calculation.
void vtkProbePass::ChooseTraits(vtkActor* actor) {
  Variant& made = this->Made;
  boxprobe::ProgramTraits traits;
  if (this->State->tuning != nullptr) {
    const bool refused = this->Last.refused || this->Last.constantsRefused;
    traits = this->State->tuning->choose({actor, this->Surface.get(), made.binding, made.key, this->Asked.tuning,
                                          made.traits, !this->Asked.debug && !this->Asked.heights,
                                          this->Mirror != nullptr || this->DrawsGlass(), refused});
  }
  if (traits.facts != made.traits.facts) {
    this->Rebuild();
  } else if (traits.firstBounce != made.traits.firstBounce || traits.constants != made.traits.constants ||
             traits.flatMaps != made.traits.flatMaps) {
    this->Built.Modified();
  }
  made.traits = std::move(traits);
}

boxprobe::SurfaceOutput vtkProbePass::OutputOf(vtkActor* actor) const {
  using boxprobe::SurfaceOutput;
  if (this->Asked.debug) {
    return SurfaceOutput::Debug;
  }
  if (this->Asked.heights) {
    return SurfaceOutput::Heights;
  }
  if (!this->Asked.separateSpecular) {
    return SurfaceOutput::Picture;
  }
  const bool blended = actor->HasTranslucentPolygonalGeometry() != 0 || this->DrawsGlass();
  const bool samples = this->Made.binding->blurredSamples() > 0 && !blended;
  return samples ? SurfaceOutput::SpecularSeparate : SurfaceOutput::SpecularSeparateNone;
}

// False if there is nothing to splice, or if an anchor is missing, which is reported; the sources are then unchanged.
bool vtkProbePass::Splice(boxprobe::ShaderSources& sources, vtkActor* actor, bool lit) {
  const boxprobe::SceneResources& resources = this->State->resources;
  boxprobe::SurfaceProgram program{this->Drawn(),           this->Surface.get(), this->OutputOf(actor),
                                   this->Mirror != nullptr, this->Made.form,     this->Made.traits.facts};
  program.flatMaps = this->Made.traits.flatMaps;
  program.foreign = resources.foreign;
  program.emission = resources.emission;
  program.tone = this->Made.tone;
  program.lightPlaces = this->Made.lightPlaces;
  const boxprobe::SpliceReport report = boxprobe::splicePbr(sources, program, lit);
  this->State->counts.fail(report.failure);
  if (!report.needed || !report.failure.empty()) {
    return false;
  }
  boxprobe::breakShaderIfAsked(sources.fragment, this->Asked.debug ? "debug" : "surface");
  if (this->Drawn().probes.size() > 1) {
    boxprobe::breakShaderIfAsked(sources.fragment, "probes");
  }
  if (this->Made.traits.constants) {
    boxprobe::writeConstants(sources.fragment, this->Made.traits.constants->values);
    boxprobe::breakShaderIfAsked(sources.fragment, "constants");
  }
  boxprobe::removeParts(sources.fragment, this->Asked.leftOut);
  if (this->Asked.cut) {
    boxprobe::AnchorEdits edits;
    boxprobe::addCutaway(sources.fragment, edits);
    this->State->counts.fail(boxprobe::spliceFailure(edits));
  }
  return true;
}

// VTK 9.1 crashes at the next use of a program that does not compile, so it is compiled here with its final source: the
// cache then has it ready, at no further cost.
bool vtkProbePass::Compiles(const boxprobe::ShaderSources& sources, vtkAbstractMapper* mapper, vtkActor* actor) const {
  boxprobe::ShaderSources text = sources;
  vtkInformation* keys = actor->GetPropertyKeys();
  bool after = false;
  for (int i = 0; i < countOfPasses(keys); ++i) {
    vtkOpenGLRenderPass* pass = passAt(keys, i);
    if (after) {
      pass->PostReplaceShaderValues(text.vertex, text.geometry, text.fragment, mapper, actor);
    }
    after = after || pass == this;
  }
  auto* own = vtkOpenGLShaderProperty::SafeDownCast(actor->GetShaderProperty());
  for (const auto& [what, by] : own->GetAllShaderReplacements()) {
    if (what.ReplaceFirst) {
      continue;
    }
    std::string& shader = what.ShaderType == vtkShader::Vertex     ? text.vertex
                          : what.ShaderType == vtkShader::Geometry ? text.geometry
                                                                   : text.fragment;
    vtkShaderProgram::Substitute(shader, what.OriginalValue, by.Replacement, by.ReplaceAll);
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->State->drawing->GetRenderWindow());
  const bool another = this->Made.traits.constants || this->WithLess() || this->WithTextureLess();
  return boxprobe::programCompiles(window, text.vertex, text.geometry, text.fragment, another);
}

// Null where there is nothing to give up. A debug program samples more than the picture's, and gives up nothing: what
// it shows is the picture's calculation.
std::shared_ptr<const boxprobe::ProbeBinding> vtkProbePass::WithLess() const {
  return this->Asked.debug || !this->Asked.binding ? nullptr : boxprobe::withLess(*this->Asked.binding);
}

std::shared_ptr<const boxprobe::SurfaceMaterial> vtkProbePass::WithTextureLess() const {
  return this->Asked.debug || !this->Surface ? nullptr : boxprobe::withTextureLess(*this->Surface);
}

bool vtkProbePass::GiveUp() {
  if (auto less = this->WithLess()) {
    ++this->LessOf[this->Asked.whole->variantKey()].steps;
    this->Asked.binding = std::move(less);
    this->UpdateDrawn();
    return true;
  }
  if (auto less = this->WithTextureLess()) {
    this->LessOf[this->Asked.whole ? this->Asked.whole->variantKey() : std::string()].textures = ++this->TexturesLess;
    this->Surface = std::move(less);
    return true;
  }
  return false;
}

// Replaces a refused program by VTK's own: an object without reflections is better than none.
void vtkProbePass::Refuse(vtkAbstractMapper* mapper, vtkActor* actor) {
  this->Last.refused = true;
  if (this->Asked.debug) {
    return;  // callers check GetDebugRefused(); the picture has another program
  }
  this->State->counts.fail(boxprobe::kSurfaceRefused);
  auto* polyMapper = vtkPolyDataMapper::SafeDownCast(mapper);
  if (this->Surface && polyMapper != nullptr) {
    // From the next frame on: the program of this one is already selected.
    boxprobe::applyPlainSurface(*this->Surface, actor->GetProperty(), polyMapper->GetInput());
  }
}

bool vtkProbePass::PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                           vtkAbstractMapper* mapper, vtkProp* prop) {
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!this->State || actor == nullptr || !this->IsFor(prop)) {
    return true;
  }
  vtkRenderer* renderer = this->State->drawing;
  if (renderer == nullptr) {
    this->Last.plain = true;
    return true;
  }
  if (!this->Made.binding || this->Last.refused) {
    return true;
  }
  vtkProperty* property = actor->GetProperty();
  if (property->GetInterpolation() != VTK_PBR || !property->GetLighting()) {
    this->State->counts.fail(captureAsLight(fragment, this->State->resources.tone));
    return true;
  }
  const bool polygons = drawsPolygonsAlone(mapper, actor);
  const bool light = anyLightOn(renderer);
  if (polygons && !light && !renderer->GetUseImageBasedLighting()) {
    this->State->counts.fail(
        "VTK shades nothing physically without a light; add one to the renderer, of intensity 0 if need be");
    return true;
  }
  this->Made.form = this->State->resources.lightForm;
  this->Made.tone = this->State->resources.tone;
  this->Made.lightPlaces = this->State->resources.lightPlaces;
  const bool lit = polygons && light;
  boxprobe::ShaderSources sources{vertex, geometry, fragment};
  if (!this->Splice(sources, actor, lit)) {
    this->State->counts.fail(captureAsLight(fragment, this->State->resources.tone));
    return true;
  }
  bool compiles = this->Compiles(sources, mapper, actor);
  if (!compiles && this->Made.traits.constants) {
    this->Made.traits.constants = nullptr;
    this->Made.traits.flatMaps = false;
    this->Last.constantsRefused = true;
    sources = {vertex, geometry, fragment};
    // Usually the program with uniforms has been drawn before, but facts may have changed together with the constants.
    compiles = this->Splice(sources, actor, lit) && this->Compiles(sources, mapper, actor);
  }
  while (!compiles && this->GiveUp()) {
    sources = {vertex, geometry, fragment};
    compiles = this->Splice(sources, actor, lit) && this->Compiles(sources, mapper, actor);
  }
  if (!compiles) {
    this->Refuse(mapper, actor);
    return true;
  }
  vertex = std::move(sources.vertex);
  geometry = std::move(sources.geometry);
  fragment = std::move(sources.fragment);
  return true;
}

bool vtkProbePass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop,
                                       vtkOpenGLVertexArrayObject*) {
  if (!this->State || !this->IsFor(prop)) {
    return true;
  }
  boxprobe::DrawState& state = *this->State;
  this->Last.run = true;
  if (state.tuning != nullptr) {
    this->Last.program = program;
    this->Last.compilation = state.tuning->uses(program, this->Made.traits.constants != nullptr);
  }
  if (this->Made.binding && state.drawing != nullptr && program->IsUniformUsed("bpExposure")) {
    this->Upload(program, prop->GetBounds());
    this->Count(program);
  } else if (program->IsUniformUsed("bpLightOfDisplay")) {
    const bool capturing = state.pass().exposure == boxprobe::kLinearOutput;
    program->SetUniformf("bpLightOfDisplay", capturing ? 1.0f / state.exposure() : 0.0f);
  }
  return true;
}

void vtkProbePass::Upload(vtkShaderProgram* program, const double* boundsWorld) {
  boxprobe::DrawState& state = *this->State;
  state.bound.clear();
  const boxprobe::UniformUpload to{program, state.drawing, state.bound, boundsWorld};
  boxprobe::uploadOutput(to, state.pass());
  if (this->Asked.cut) {
    const bool ofView = state.drawing == state.shown.GetPointer() || this->Asked.objectNumber > 0;
    const bool inView = state.cut && ofView;
    boxprobe::uploadCutaway(program, state.drawing, inView ? &*state.cut : nullptr);
  }
  if (this->Surface) {
    boxprobe::uploadMaterial(to, *this->Surface);
  }
  const boxprobe::ProbeBinding& binding = *this->Made.binding;
  if (binding.lighting == Lighting::Probes) {
    const auto& constants = this->Made.traits.constants;
    boxprobe::uploadLighting(to, state, this->Drawn(), this->Asked.debug, constants ? &constants->values : nullptr,
                             this->Made.traits.flatMaps);
    if (this->Mirror) {
      boxprobe::uploadMirror(to, *this->Mirror, state.resources);
    }
    if (this->DrawsGlass()) {
      boxprobe::uploadGlassOf(to, this->Surface->glass, binding, state.resources, state.pass().behind);
    }
  } else if (this->Made.form == boxprobe::LightForm::Multiple) {
    boxprobe::uploadSplitSum(to, state.resources);
  }
  if (!state.resources.listedLights->empty() && program->IsUniformUsed("bpLightList")) {
    boxprobe::uploadListedLights(to, *state.resources.listedLights);
  }
  if (this->Asked.heights) {
    program->SetUniform4f("bpHeightPlane", &state.pass().heightPlaneView.x);
  }
  if (this->Asked.debug) {
    boxprobe::uploadView(to, state, binding, this->Asked.objectNumber);
  }
}

void vtkProbePass::Count(vtkShaderProgram* program) {
  boxprobe::FrameCounts& counts = this->State->counts;
  if (!this->State->pass().countDraws || this->Again) {
    return;
  }
  this->Last.programNumber = static_cast<unsigned>(program->GetHandle());
  this->Last.frame = counts.counters.renders;
  counts.draws(program);
  const boxprobe::ProbeBinding& binding = *this->Made.binding;
  const bool probes = binding.lighting == Lighting::Probes;
  ++counts.counters.drawsByProbeCount[probes ? binding.probes.size() : 0];
  counts.counters.drawsWithCoverage += probes && !binding.shadowLights.empty() ? 1 : 0;
  counts.counters.drawsWithOpenSky += probes && binding.open() ? 1 : 0;
}
