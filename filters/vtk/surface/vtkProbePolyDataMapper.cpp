#include "filters/vtk/surface/vtkProbePolyDataMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkRenderer.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "filters/core/picture/probe_color.h"
#include "filters/vtk/gl/broken_shader.h"
#include "filters/vtk/surface/camera_uniforms.h"
#include "filters/vtk/surface/coverage_uniforms.h"
#include "filters/vtk/surface/glass_draw.h"
#include "filters/vtk/surface/plain_surface.h"
#include "filters/vtk/surface/probe_source.h"
#include "filters/vtk/surface/static_textures.h"
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
  return this->State && this->Frame + 1 == this->State->counters.renders;
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
  if (this->State->error.empty()) {
    this->State->error =
        "this OpenGL driver refuses the shader of a surface with probes; it is drawn without reflections";
  }
  this->Refused = true;
  this->Superclass::BuildShaders(shaders, renderer, actor);
  if (this->Surface) {
    // From the next frame on: this one's program has been chosen.
    boxprobe::givePlainSurface(*this->Surface, actor->GetProperty(), this->CurrentInput);
  }
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
  const std::string failure =
      boxprobe::splicePbr(sources, *this->Drawn, this->Surface.get(), output, this->Mirror != nullptr);
  if (!failure.empty() && this->State->error.empty()) {
    this->State->error = failure;
  }
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
  this->Superclass::UpdateShaders(cellBO, renderer, actor);
  if (!this->State) {
    return;
  }
  if (cellBO.Program != nullptr && this->State->programs.insert(cellBO.Program).second) {
    ++this->State->counters.programsCompiled;
  }
}

void vtkProbePolyDataMapper::SetCameraShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* renderer,
                                                       vtkActor* actor) {
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  vtkShaderProgram* program = cellBO.Program;
  if (!this->State || !this->Drawn || !program->IsUniformUsed("bpExposure")) {
    return;
  }
  program->SetUniformf("bpExposure", this->State->exposure);
  program->SetUniformf("bpParallel", renderer->GetActiveCamera()->GetParallelProjection() ? 1.0f : 0.0f);
  if (this->Surface) {
    this->UploadSurface(program, renderer);
  }
  const bool probes = this->Drawn->lighting == Lighting::Probes;
  if (probes) {
    this->UploadProbes(program, renderer);
  }
  if (this->Heights) {
    program->SetUniform4f("bpHeightPlane", &this->State->heightPlaneView.x);
  }
  if (this->Debug) {
    this->UploadDebug(program, renderer);
  }
  if (this->State->countDraws && !this->Again) {
    this->Frame = this->State->counters.renders;
    ++this->State->counters.drawsByProbeCount[probes ? this->Drawn->probes.size() : 0];
    this->State->counters.drawsWithCoverage += probes && !this->Drawn->shadowLights.empty() ? 1 : 0;
    this->State->counters.drawsWithOpenSky += probes && this->Drawn->open() ? 1 : 0;
  }
}

int vtkProbePolyDataMapper::Bind(vtkRenderer* renderer, unsigned int target, unsigned int handle) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Bound.push_back(std::make_unique<boxprobe::BoundTexture>(window, target, handle));
  return this->Bound.back()->unit();
}

void vtkProbePolyDataMapper::UploadSurface(vtkShaderProgram* program, vtkRenderer* renderer) {
  const boxprobe::SurfaceMaterial& surface = *this->Surface;
  program->SetUniformf("bpAlpha", surface.alpha);
  program->SetUniformf("bpAlphaCutoff", surface.alphaCutoff);
  program->SetUniformf("bpNormalScale", surface.normalScale);
  program->SetUniformf("bpCoatNormalScale", surface.coatNormalScale);
  for (std::size_t i = 0; i < surface.slots.size(); ++i) {
    const boxprobe::SurfaceSlot& slot = surface.slots[i];
    if (!slot.texture) {
      continue;
    }
    const std::string name = boxprobe::surfaceSlotNames()[i];
    // A slot that this variant does not read would only take a unit.
    if (!program->IsUniformUsed(("bpTex" + name).c_str())) {
      continue;
    }
    program->SetUniformi(("bpTex" + name).c_str(), this->Bind(renderer, GL_TEXTURE_2D, slot.texture->handle()));
    const glm::mat3x2& m = slot.uvTransform;
    const float rows[2][3] = {{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}};
    program->SetUniform3fv(("bpUv" + name).c_str(), 2, rows);
  }
}

void vtkProbePolyDataMapper::UploadProbes(vtkShaderProgram* program, vtkRenderer* renderer) {
  ++this->State->counters.uniformUpdates;
  program->SetUniformMatrix3x3("bpViewToWorld", boxprobe::viewToWorldRotation(renderer->GetActiveCamera()).data());
  program->SetUniformi("bpBrdf", this->Bind(renderer, GL_TEXTURE_2D, this->State->brdfTable));

  if (this->Drawn->sky || this->Drawn->open()) {
    this->UploadSky(program, renderer);
  }
  if (this->Mirror) {
    this->UploadMirror(program, renderer);
  }
  if (!this->Drawn->probes.empty()) {
    this->UploadSlots(program, renderer);
  }
  if (!this->Drawn->shadowLights.empty()) {
    const double* eye = renderer->GetActiveCamera()->GetPosition();
    boxprobe::uploadCoverage(program, vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), *this->State,
                             *this->Drawn, glm::dvec3(eye[0], eye[1], eye[2]), this->Bound);
  }
  if (this->DrawsGlass()) {
    this->UploadGlass(program, renderer);
  }
}

void vtkProbePolyDataMapper::UploadGlass(vtkShaderProgram* program, vtkRenderer* renderer) {
  const boxprobe::GlassSurface& glass = this->Surface->glass;
  int faceSize = this->State->sky ? this->State->sky->radiance.faceSize() : 0;
  for (const auto& probe : this->Drawn->probes) {
    if (probe->maps) {
      faceSize = std::max(faceSize, probe->maps->radiance.faceSize());
    }
  }
  const bool followed = glass.shell && program->IsUniformUsed("bpGlassShell");
  const int unit = followed ? this->Bind(renderer, GL_TEXTURE_CUBE_MAP, glass.shell->handle()) : -1;
  const double* eye = renderer->GetActiveCamera()->GetPosition();
  boxprobe::uploadGlass(program, glass, glm::dvec3(eye[0], eye[1], eye[2]), faceSize, unit);
}

void vtkProbePolyDataMapper::UploadMirror(vtkShaderProgram* program, vtkRenderer* renderer) {
  const boxprobe::MirrorPicture& mirror = *this->Mirror;
  program->SetUniformf("bpMirrorOn", mirror.shown ? 1.0f : 0.0f);
  const unsigned int none = this->State->brdfTable;  // not read
  program->SetUniformi("bpMirrorColor", this->Bind(renderer, GL_TEXTURE_2D, mirror.shown ? mirror.color : none));
  program->SetUniformi("bpMirrorHeight", this->Bind(renderer, GL_TEXTURE_2D, mirror.shown ? mirror.height : none));
  const boxprobe::shading::MirrorLook& look = mirror.look;
  const std::array<glm::vec4, 3> places = {look.toU, look.toV, look.toW};
  program->SetUniform4fv("bpMirrorPlaces", 3, reinterpret_cast<const float(*)[4]>(&places[0].x));
  const glm::vec4 normal(look.normal, look.farHeight), eye(look.eye, look.texelSize);
  program->SetUniform4f("bpMirrorNormal", &normal.x);
  program->SetUniform4f("bpMirrorEye", &eye.x);
  const glm::vec3 levels(look.parallel, look.maxLevel, look.sharpLevel);
  program->SetUniform3f("bpMirrorLevels", &levels.x);
  const glm::vec2 size(look.sizeX, look.sizeY);
  program->SetUniform2f("bpMirrorSize", &size.x);
}

void vtkProbePolyDataMapper::UploadDebug(vtkShaderProgram* program, vtkRenderer* renderer) {
  const boxprobe::DebugDraw& debug = this->State->debug;
  program->SetUniformi("bpView", debug.view);
  const float range[2] = {debug.low, debug.high};
  program->SetUniform2f("bpViewRange", range);
  if (debug.colorMap != 0) {
    program->SetUniformi("bpViewColors", this->Bind(renderer, GL_TEXTURE_2D, debug.colorMap));
  }
  const auto& faces = boxprobe::faceColors();
  program->SetUniform3fv("bpFaceColors", 6, reinterpret_cast<const float(*)[3]>(&faces[0].x));
  program->SetUniformf("bpObject", static_cast<float>(this->ObjectNumber));
  if (this->Drawn->lighting != Lighting::Probes) {
    program->SetUniformMatrix3x3("bpViewToWorld", boxprobe::viewToWorldRotation(renderer->GetActiveCamera()).data());
    return;
  }
  const glm::vec3 sky = boxprobe::skyColor();
  program->SetUniform3f("bpSkyColor", &sky.x);
  constexpr std::size_t kMax = boxprobe::ProbeBinding::kMaxProbesPerDraw;
  std::array<glm::vec3, kMax> color;
  std::array<float, kMax> faceSize{};
  const std::size_t count = this->Drawn->probes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const boxprobe::DrawnProbe& probe = *this->Drawn->probes[i];
    color[i] = boxprobe::probeColor(probe.index);
    const bool known = probe.maps != nullptr && probe.maps->distance.allocated();
    faceSize[i] = known ? static_cast<float>(probe.maps->distance.faceSize()) : 0.0f;
  }
  if (count > 0) {
    program->SetUniform3fv("bpProbeColor", static_cast<int>(count), reinterpret_cast<const float(*)[3]>(&color[0].x));
    program->SetUniform1fv("bpDistanceFaceSize", static_cast<int>(count), faceSize.data());
  }
}

void vtkProbePolyDataMapper::UploadSky(vtkShaderProgram* program, vtkRenderer* renderer) {
  const auto& sky = this->State->sky;
  program->SetUniformi(
      "bpSkyMap", this->Bind(renderer, GL_TEXTURE_CUBE_MAP, sky ? sky->radiance.handle() : this->State->blackCube));
  program->SetUniformf("bpSkyMaxLevel", sky ? sky->maxLevel() : 0.0f);
  program->SetUniformf("bpSkyIntensity", sky ? 1.0f : 0.0f);
  boxprobe::ShCoefficients skySh{};
  if (sky) {
    skySh = sky->irradiance;
  }
  program->SetUniform3fv("bpSkySh", 9, reinterpret_cast<const float(*)[3]>(&skySh[0].x));
}

void vtkProbePolyDataMapper::UploadRelief(vtkShaderProgram* program, vtkRenderer* renderer) {
  const std::size_t count = this->Drawn->probes.size();
  constexpr std::size_t kMax = boxprobe::ProbeBinding::kMaxProbesPerDraw, kMost = boxprobe::ReliefBlocks::kMost;
  std::array<int, kMax> blocks{};
  std::array<glm::vec3, kMax * kMost> low{}, high{};
  for (std::size_t i = 0; i < count; ++i) {
    const boxprobe::DrawnProbe& probe = *this->Drawn->probes[i];
    const boxprobe::ProbeMaps* maps = this->State->firstBounce ? nullptr : probe.maps.get();
    const bool known = maps != nullptr && maps->distance.allocated();
    if (known) {
      const auto found = maps->relief.blocks(maps->distance, probe.geometry, this->State->dragging);
      blocks[i] = found->count;
      std::copy(found->low.begin(), found->low.end(), low.begin() + static_cast<long>(i * kMost));
      std::copy(found->high.begin(), found->high.end(), high.begin() + static_cast<long>(i * kMost));
    }
    program->SetUniformi(
        ("bpRelief" + std::to_string(i)).c_str(),
        this->Bind(renderer, GL_TEXTURE_CUBE_MAP, known ? maps->relief.handle() : this->State->blackCube));
  }
  program->SetUniform1iv("bpBlockCount", static_cast<int>(count), blocks.data());
  const int most = static_cast<int>(count * kMost);
  program->SetUniform3fv("bpBlockLow", most, reinterpret_cast<const float(*)[3]>(&low[0].x));
  program->SetUniform3fv("bpBlockHigh", most, reinterpret_cast<const float(*)[3]>(&high[0].x));
}

void vtkProbePolyDataMapper::UploadSlots(vtkShaderProgram* program, vtkRenderer* renderer) {
  const std::size_t count = this->Drawn->probes.size();
  constexpr std::size_t kMax = boxprobe::ProbeBinding::kMaxProbesPerDraw;
  std::array<glm::vec3, kMax> origin, boxMin, boxMax, influenceMin, influenceMax, rateMin, rateMax;
  std::array<float, kMax> intensity{}, maxLevel{};
  std::array<glm::mat3, kMax> worldFromProbe{}, mapFromProbe{};
  std::array<glm::vec3, 9 * kMax> sh{};
  const double* eye = renderer->GetActiveCamera()->GetPosition();
  for (std::size_t i = 0; i < count; ++i) {
    const boxprobe::DrawnProbe& probe = *this->Drawn->probes[i];
    const boxprobe::ProbeGeometry& g = probe.geometry;
    origin[i] = glm::vec3(g.originWorld - glm::dvec3(eye[0], eye[1], eye[2]));
    boxMin[i] = g.boxMin;
    boxMax[i] = g.boxMax;
    influenceMin[i] = g.influenceMin;
    influenceMax[i] = g.influenceMax;
    rateMin[i] = g.rateMin;
    rateMax[i] = g.rateMax;
    worldFromProbe[i] = glm::mat3(g.worldFromProbe);
    mapFromProbe[i] = glm::mat3(g.mapFromProbe);
    // Without maps: no reflection, and the sky's diffuse light, which is the best guess there is.
    const boxprobe::ProbeMaps* maps = this->State->firstBounce ? nullptr : probe.maps.get();
    const boxprobe::ProbeMaps* diffuse = maps != nullptr ? maps : this->State->sky.get();
    intensity[i] = g.intensity;
    maxLevel[i] = maps != nullptr ? maps->maxLevel() : 0.0f;
    if (diffuse != nullptr) {
      std::copy(diffuse->irradiance.begin(), diffuse->irradiance.end(), sh.begin() + static_cast<long>(9 * i));
    }
    // Not in a capture that goes without the sky.
    if (maps != nullptr && probe.open && this->State->sky) {
      for (std::size_t k = 0; k < 9; ++k) {
        sh[9 * i + k] += probe.openSky[k];
      }
    }
    program->SetUniformi(
        ("bpMap" + std::to_string(i)).c_str(),
        this->Bind(renderer, GL_TEXTURE_CUBE_MAP, maps != nullptr ? maps->radiance.handle() : this->State->blackCube));
  }
  if (this->Debug) {
    for (std::size_t i = 0; i < count; ++i) {
      const boxprobe::ProbeMaps* maps = this->Drawn->probes[i]->maps.get();
      const bool known = maps != nullptr && maps->distance.allocated();
      program->SetUniformi(
          ("bpDistanceMap" + std::to_string(i)).c_str(),
          this->Bind(renderer, GL_TEXTURE_CUBE_MAP, known ? maps->distance.handle() : this->State->blackCube));
    }
  }
  if (this->Drawn->distances()) {
    this->UploadRelief(program, renderer);
  }
  if (this->Drawn->chooses("sampling", "luminance")) {
    std::array<int, kMax> size{};
    for (std::size_t i = 0; i < count; ++i) {
      const boxprobe::ProbeMaps* maps = this->State->firstBounce ? nullptr : this->Drawn->probes[i]->maps.get();
      if (maps != nullptr) {
        maps->light.make(maps->radiance);
        size[i] = maps->light.faceSize();
      }
      const unsigned int handle = size[i] > 0 ? maps->light.handle() : this->State->brdfTable;  // not read
      program->SetUniformi(("bpLight" + std::to_string(i)).c_str(), this->Bind(renderer, GL_TEXTURE_2D, handle));
    }
    program->SetUniform1iv("bpLightSize", static_cast<int>(count), size.data());
  }
  if (this->Drawn->chooses("pattern", "blue")) {
    boxprobe::makeBlueNoise(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), *this->State);
    program->SetUniformi("bpBlueNoise", this->Bind(renderer, GL_TEXTURE_2D, this->State->blueNoise));
  }
  if (program->IsUniformUsed("bpPixelOrigin")) {
    program->SetUniform2i("bpPixelOrigin", &this->State->pixelOrigin.x);
  }
  if (program->IsUniformUsed("bpFrame")) {
    program->SetUniformi("bpFrame", this->State->frame);
  }
  const int n = static_cast<int>(count);
  const auto upload = [program, n](const char* name, const std::array<glm::vec3, kMax>& values) {
    program->SetUniform3fv(name, n, reinterpret_cast<const float(*)[3]>(&values[0].x));
  };
  upload("bpOrigin", origin);
  upload("bpBoxMin", boxMin);
  upload("bpBoxMax", boxMax);
  upload("bpInfluenceMin", influenceMin);
  upload("bpInfluenceMax", influenceMax);
  upload("bpRateMin", rateMin);
  upload("bpRateMax", rateMax);
  program->SetUniform1fv("bpIntensity", n, intensity.data());
  program->SetUniform1fv("bpMaxLevel", n, maxLevel.data());
  program->SetUniform3fv("bpSh", 9 * n, reinterpret_cast<const float(*)[3]>(&sh[0].x));
  for (const boxprobe::ParameterRow* row : this->Drawn->parameters()) {
    if (row->number == nullptr) {
      continue;
    }
    std::array<float, kMax> values{};
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = this->Drawn->probes[i]->geometry.parameters.*row->number;
    }
    program->SetUniform1fv(boxprobe::parameterUniform(*row).c_str(), n, values.data());
  }
  if (this->Drawn->bevelled()) {
    std::array<glm::vec2, kMax> bevel{};
    for (std::size_t i = 0; i < count; ++i) {
      const boxprobe::ProbeGeometry& g = this->Drawn->probes[i]->geometry;
      bevel[i] = glm::vec2(g.bevelRadius, g.bevelFromRoughness);
    }
    program->SetUniform2fv("bpBevel", n, reinterpret_cast<const float(*)[2]>(&bevel[0].x));
  }
  if (this->Drawn->occluded()) {
    std::array<glm::vec3, kMax> occlusion{};
    for (std::size_t i = 0; i < count; ++i) {
      occlusion[i] = this->Drawn->probes[i]->geometry.occlusion;
    }
    upload("bpOcclusion", occlusion);
  }
  if (this->Drawn->weights && !this->Drawn->shares.empty()) {
    program->SetUniform1fv("bpShare", n, this->Drawn->shares.data());
    program->SetUniformf("bpSkyShare", this->Drawn->skyShare);
  }
  // As the program was made: what a box is turned by, or against its maps, may have come to 0 since.
  if (program->IsUniformUsed("bpWorldFromProbe")) {
    // VTK sets one matrix a call; array elements have names of their own, but for the first.
    const auto uploadMatrices = [program, count](const std::string& name, std::array<glm::mat3, kMax>& values) {
      for (std::size_t i = 0; i < count; ++i) {
        program->SetUniformMatrix3x3((i == 0 ? name : name + "[" + std::to_string(i) + "]").c_str(), &values[i][0].x);
      }
    };
    uploadMatrices("bpWorldFromProbe", worldFromProbe);
    uploadMatrices("bpMapFromProbe", mapFromProbe);
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
  if (this->State->countDraws) {
    ++this->State->counters.glassDraws;
    this->State->counters.glassPasses += static_cast<std::uint64_t>(passes);
  }
}

void vtkProbePolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) {
  this->Superclass::RenderPieceFinish(renderer, actor);
  this->Bound.clear();
}
