#include "filters/vtk/actors/actor_parts.h"

#include <vtkAssemblyPath.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLightCollection.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRendererCollection.h>
#include <vtkSkybox.h>
#include <vtkTexture.h>

#include <cmath>
#include <set>

#include "filters/core/base/at_end.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/maps/content_hash.h"
#include "filters/vtk/probes/probe_assignment.h"

namespace boxprobe {

namespace {

constexpr int kSkyFaceSize = 256;
constexpr const char* kNoContext =
    "the render window has no OpenGL context yet; show its widget first, or leave the capture to the first Render()";

/// A texture without any memory: VTK's windows tell textures before the context goes, and nobody else.
class ContextWatch : public vtkTextureObject {
 public:
  static ContextWatch* New() { VTK_STANDARD_NEW_BODY(ContextWatch); }
  vtkTypeMacro(ContextWatch, vtkTextureObject) void ReleaseGraphicsResources(vtkWindow* window) override {
    if (this->Lost) this->Lost();
    this->Superclass::ReleaseGraphicsResources(window);
  }
  std::function<void()> Lost;
};

bool shadedPhysically(vtkActor* actor) {
  return actor->GetProperty()->GetInterpolation() == VTK_PBR && actor->GetProperty()->GetLighting();
}

ActorState stateOf(vtkActor* actor, const std::array<double, 6>* placedBounds) {
  ActorState state;
  if (placedBounds != nullptr) {
    state.bounds = *placedBounds;
  } else if (const double* b = actor->GetBounds()) {
    std::copy(b, b + 6, state.bounds.begin());
  }
  vtkProperty* property = actor->GetProperty();
  const bool textured = property->GetTexture("materialTex") != nullptr;
  state.roughnessMin = textured ? 0.0 : property->GetRoughness();
  state.roughnessMax = property->GetRoughness();
  if (property->GetCoatStrength() > 0.0) {
    state.roughnessMin = std::min(state.roughnessMin, property->GetCoatRoughness());
    state.roughnessMax = std::max(state.roughnessMax, property->GetCoatRoughness());
  }
  state.allMetal = property->GetMetallic() == 1.0 && !textured;
  return state;
}

/// A light that captures see where the renderer's stands: those that follow its camera must not follow the captures'.
vtkSmartPointer<vtkLight> standing(vtkLight* light) {
  auto copy = vtkSmartPointer<vtkLight>::New();
  copy->DeepCopy(light);
  copy->SetLightTypeToSceneLight();
  copy->SetTransformMatrix(nullptr);
  double at[3], towards[3];
  light->GetTransformedPosition(at);
  light->GetTransformedFocalPoint(towards);
  copy->SetPosition(at);
  copy->SetFocalPoint(towards);
  return copy;
}

bool waitsForContext(vtkRenderWindow* window) {
  auto* foreign = vtkGenericOpenGLRenderWindow::SafeDownCast(window);
  return foreign != nullptr && !foreign->GetReadyForRendering();
}

/// Null: nothing. A widget's window is begun here, since it may not have drawn yet. Throws WorkError without a context.
void makeCurrent(vtkOpenGLRenderWindow* window, bool begun) {
  if (window == nullptr) return;
  if (waitsForContext(window)) throw WorkError(kNoContext);
  const bool foreign = vtkGenericOpenGLRenderWindow::SafeDownCast(window) != nullptr;
  if (!foreign) window->Initialize();
  window->MakeCurrent();
  if (!window->IsCurrent()) throw WorkError(kNoContext);
  if (foreign && !begun) window->OpenGLInit();
}

void addNumbers(ContentHash& hash, const double* values, int count) {
  for (int i = 0; i < count; ++i) hash.add(values[i]);
}

template <typename T>
void addAddress(ContentHash& hash, const T* object) {
  hash.addBytes(&object, sizeof object);
}

// Values, where they are few: a program may set the same colour in every frame.
void addProperty(ContentHash& hash, vtkProperty* p) {
  for (const double* color : {p->GetColor(), p->GetAmbientColor(), p->GetDiffuseColor(), p->GetSpecularColor(),
                              p->GetEdgeColor(), p->GetEmissiveFactor(), p->GetCoatColor(), p->GetEdgeTint()}) {
    addNumbers(hash, color, 3);
  }
  for (const double value :
       {p->GetAmbient(), p->GetDiffuse(), p->GetSpecular(), p->GetSpecularPower(), p->GetOpacity(), p->GetMetallic(),
        p->GetRoughness(), p->GetBaseIOR(), p->GetCoatStrength(), p->GetCoatIOR(), p->GetCoatRoughness(),
        p->GetNormalScale(), p->GetOcclusionStrength(), p->GetAnisotropy(), p->GetAnisotropyRotation(),
        static_cast<double>(p->GetLineWidth()), static_cast<double>(p->GetPointSize())}) {
    hash.add(value);
  }
  for (const int value :
       {p->GetInterpolation(), p->GetRepresentation(), static_cast<int>(p->GetLighting()), p->GetEdgeVisibility(),
        static_cast<int>(p->GetVertexVisibility()), p->GetBackfaceCulling(), p->GetFrontfaceCulling()}) {
    hash.add(static_cast<double>(value));
  }
  for (const auto& [name, texture] : p->GetAllTextures()) {
    hash.add(name);
    addAddress(hash, texture);
    hash.add(texture != nullptr ? static_cast<double>(texture->GetMTime()) : 0.0);
  }
}

void addLight(ContentHash& hash, vtkLight* light) {
  hash.add(light->GetIntensity()).add(light->GetConeAngle()).add(light->GetExponent());
  hash.add(static_cast<double>(light->GetLightType())).add(static_cast<double>(light->GetPositional()));
  addNumbers(hash, light->GetDiffuseColor(), 3);
  addNumbers(hash, light->GetAttenuationValues(), 3);
  if (light->LightTypeIsHeadlight()) return;  // where the camera is
  addNumbers(hash, light->GetPosition(), 3);
  addNumbers(hash, light->GetFocalPoint(), 3);
}

Box boxOf(const std::array<double, 6>& b) {
  return Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

}  // namespace

ActorParts::ActorParts(vtkRenderer* shown)
    : renderer(shown != nullptr ? vtkSmartPointer<vtkRenderer>(shown) : vtkSmartPointer<vtkRenderer>::New()),
      nothing(shown == nullptr),
      state(std::make_shared<DrawState>()),
      shownProbes(&content.scene, state),
      light(&content, state, &shownProbes) {
  state->resources.foreign = true;
  state->resources.emission = false;
  content.scene.sky = SkyColor{};
  content.sky->SetDrawState(state);
  lightSky->SetDrawState(state);
  state->shown = renderer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject* caller, unsigned long event, void* client, void*) {
    auto* all = static_cast<ActorParts*>(client);
    event == vtkCommand::StartEvent ? all->starts(caller) : all->endFrame();
    if (event == vtkCommand::EndEvent && caller == all->renderer && all->afterFrame) all->afterFrame();
  });
  refreshSky();
  observeWindow();
}

ActorParts::~ActorParts() {
  for (const auto& one : observed) {
    if (one != nullptr) one->RemoveObserver(observer);
  }
  for (LitActor& lit : actors) lit.pass->Detach();
  release();
}

// Every renderer of the window may show the actors: each is drawn by its own camera.
void ActorParts::observeWindow() {
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const auto observe = [this](vtkObject* object, bool end) {
    for (const auto& one : observed) {
      if (one.GetPointer() == object) return false;
    }
    observed.emplace_back(object);
    object->AddObserver(vtkCommand::StartEvent, observer);
    if (end) object->AddObserver(vtkCommand::EndEvent, observer);
    return true;
  };
  observed.erase(std::remove_if(observed.begin(), observed.end(),
                                [](const vtkWeakPointer<vtkObject>& one) { return one.GetPointer() == nullptr; }),
                 observed.end());
  bool more = observe(renderer, true);
  observedWindow = window;
  if (window == nullptr) return;
  observe(window, false);
  vtkCollectionSimpleIterator it;
  vtkRendererCollection* all = window->GetRenderers();
  all->InitTraversal(it);
  while (vtkRenderer* one = all->GetNextRenderer(it)) more |= observe(one, true);
  if (!more) return;
  for (LitActor& lit : actors) lit.pass->RebuildIfPlain();
}

void ActorParts::starts(vtkObject* caller) {
  auto* drawn = vtkRenderer::SafeDownCast(caller);
  const bool first = drawn == renderer && observedWindow != renderer->GetRenderWindow();
  if (drawn == nullptr || first) {
    observeWindow();
    if (beforeFrame) beforeFrame();
    // A renderer that comes first may show the same actors.
    place();
    assign();
  }
  if (drawn != nullptr) beginFrame(drawn);
}

ActorParts::Graphics& ActorParts::ready() {
  if (nothing) throw InputError("probes need a renderer; they were made with a null one");
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr) {
    throw InputError("probes need a renderer that belongs to a vtkOpenGLRenderWindow; call AddRenderer() first");
  }
  if (waitsForContext(window)) throw WorkError(kNoContext);
  if (graphics && graphics->window != window) release();
  if (!graphics) {
    graphics = std::make_unique<Graphics>(window, state);
    const auto watch = vtkSmartPointer<ContextWatch>::New();
    watch->Lost = [this] { release(); };
    watch->SetContext(window);
    contextWatch = watch;
  }
  makeStaticTextures(window, state->resources, state->counts);
  return *graphics;
}

void ActorParts::beginFrame(vtkRenderer* drawn) {
  state->drawing = drawn;
  try {
    ready();
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
    state->drawing = nullptr;  // and so VTK's own programs, until the next frame asks for ours again
    for (LitActor& lit : actors) lit.pass->Rebuild();
    return;
  }
  vtkOpenGLState* gl = graphics->window->GetState();
  seamlessBefore = gl->GetEnumState(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  refreshSky();
  // Seen at once where there is nothing to filter: no light at all.
  if (skyStale() && !work && !skyGiven && surroundings.light() == nullptr) captureSky(*graphics);
  if (drawn == renderer) {
    place();
    assign();
  }
  for (LitActor& lit : actors) lit.pass->RebuildIfPlain();
}

void ActorParts::endFrame() {
  if (state->drawing == renderer) remarkUnasked();
  state->bound.clear();
  if (!seamlessBefore && state->drawing != nullptr && graphics)
    graphics->window->GetState()->vtkglDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state->drawing = nullptr;
}

// Which actors other props of the renderer draw, where; and every pass among the keys that are drawn with.
void ActorParts::place() {
  parts.clear();
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it)) {
    if (prop->IsA("vtkAssembly") == 0) continue;
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath()) {
      vtkProp* part = path->GetLastNode()->GetViewProp();
      auto* actor = vtkActor::SafeDownCast(part);
      vtkMapper* mapper = actor != nullptr ? actor->GetMapper() : nullptr;
      if (mapper == nullptr) continue;
      ActorPlace& there = parts[part];
      vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix();
      double b[6];
      mapper->GetBounds(b);
      const bool first = there.owner == nullptr;
      there.owner = prop;
      if (first) there.bounds = {1e300, -1e300, 1e300, -1e300, 1e300, -1e300};
      for (int corner = 0; corner < 8; ++corner) {
        const double in[4] = {b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)], 1.0};
        double out[4];
        matrix->MultiplyPoint(in, out);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          there.bounds[2 * axis] = std::min(there.bounds[2 * axis], out[axis]);
          there.bounds[2 * axis + 1] = std::max(there.bounds[2 * axis + 1], out[axis]);
        }
      }
      std::copy_n(matrix->GetData(), 16, there.matrix.begin());
    }
  }
  for (LitActor& lit : actors) {
    const auto part = parts.find(lit.actor);
    lit.pass->Attach(lit.actor, part != parts.end() ? part->second.owner : lit.actor.Get());
  }
}

void ActorParts::assign() {
  const auto drawn = shownProbes.all();
  for (std::size_t i = 0; i < actors.size(); ++i) {
    LitActor& lit = actors[i];
    const auto part = parts.find(lit.actor);
    const ActorState now = stateOf(lit.actor, part != parts.end() ? &part->second.bounds : nullptr);
    if (lit.assigned && now == lit.state) continue;
    lit.state = now;
    lit.assigned = true;
    DrawnObject& object = content.objects[i];
    object.allMetal = now.allMetal;
    object.roughnessMin = now.roughnessMin;
    object.roughnessMax = now.roughnessMax;
    object.placedBounds = boxOf(now.bounds);
    lit.pass->SetBinding(assignProbes(object, content.scene, drawn, places.meeting(worldBounds(object)), true, false));
  }
}

void ActorParts::probesChanged() {
  shownProbes.updateShapes();
  light.updateShadowLights();
  light.updateOpenings();
  for (std::size_t i = 0; i < shownProbes.size(); ++i) {
    // Means of frames and smoothed samples take passes over the picture, which is not ours.
    shownProbes.drawn(i).geometry.animated = shownProbes.drawn(i).geometry.blurred = false;
  }
  places = ProbeIndex(content.scene.probes);
  captured.resize(content.scene.probes.size());
  for (LitActor& lit : actors) lit.assigned = false;
}

void ActorParts::show(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  shownProbes.show(index, std::move(maps));
  probesChanged();
}

// Of a sky that was given, captures see what lights; else they see the background, too, which lights nothing.
void ActorParts::refreshSky() {
  if (skyGiven) return;
  if (!surroundings.read(renderer)) return;
  state->counts.fail(surroundings.problem());
  const OrientedSky& backdrop = surroundings.backdrop();
  content.sky->SetSky(backdrop.sky, 0.0, backdrop.image);
  content.sky->SetSkyFromWorld(backdrop.pictureFromWorld);
  if (const OrientedSky* lit = surroundings.light()) {
    lightSky->SetSky(lit->sky, 0.0, lit->image);
    lightSky->SetSkyFromWorld(lit->pictureFromWorld);
  }
  ++skyWanted;
}

FaceSource ActorParts::everythingSeen(bool sky) const {
  FaceSource source;
  std::set<vtkProp*> taken;
  for (const DrawnObject& object : content.objects) {
    if (!object.settings.seenByProbes) continue;
    const auto part = parts.find(object.actor);
    vtkProp* prop = part != parts.end() ? part->second.owner : object.actor.Get();
    if (prop->GetVisibility() != 0 && taken.insert(prop).second) source.props.push_back(prop);
  }
  if (sky) source.props.push_back(content.sky);
  for (const auto& one : captureLights) source.lights.push_back(one);
  return source;
}

// The light of the surroundings, as a map at infinity. Without any it is no map, and so black.
void ActorParts::captureSky(Graphics& with) {
  skyShown = skyWanted;
  if (!skyGiven && surroundings.light() == nullptr) {
    state->resources.sky = nullptr;
    probesChanged();
    return;
  }
  BakeItem item;
  item.sky = true;
  item.faceSize = kSkyFaceSize;
  item.settings.samplesPerTexelSide = 4;
  item.face = [this](int) { return FaceSource{nullptr, {lightSky}, {captureLights.front()}}; };
  item.publish = [this](std::shared_ptr<const ProbeMaps> maps) {
    state->resources.sky = std::move(maps);
    probesChanged();
  };
  with.runner.start(std::move(item));
}

// Values that are not set follow the box and what there is to see: a room of a millimetre, or of a kilometre.
CaptureSettings ActorParts::clippedSettings(std::size_t index) const {
  const Probe& probe = content.scene.probes[index];
  CaptureSettings settings = captureSettings(probe);
  const Probe standard;
  if (probe.nearDistance == standard.nearDistance) {
    const glm::dvec3 half = 0.5 * probe.box.size();
    const double smallest = std::min({half.x, half.y, half.z});
    const glm::dvec3 size = probe.box.size();
    settings.nearDistance = 0.0025 * (smallest > 0.0 ? smallest : std::max({half.x, half.y, half.z, 1e-30}));
    if (std::max({size.x, size.y, size.z}) <= 0.0) settings.nearDistance = standard.nearDistance;
    constexpr double kKept = 8.0;  // times as near or far: a box of about the size
    const double kept = captured[index].nearDistance;
    if (kept > settings.nearDistance / kKept && kept < settings.nearDistance * kKept) settings.nearDistance = kept;
  }
  if (probe.farDistance == standard.farDistance) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < actors.size(); ++i) {
      if (!content.objects[i].settings.seenByProbes) continue;
      const Box b = boxOf(actors[i].state.bounds);
      if (b.min.x > b.max.x) continue;
      const glm::dvec3 reach = glm::max(glm::abs(b.min - probe.origin), glm::abs(b.max - probe.origin));
      farthest = std::max(farthest, glm::length(reach));
    }
    settings.farDistance = std::max(1.01 * farthest, 1000.0 * settings.nearDistance);
  }
  return settings;
}

// An upper bound of the probe's weight over each cell, by its bounds: exact where a cell lies along the box's axes.
bool ActorParts::reaches(std::size_t index) const {
  const Probe& probe = content.scene.probes[index];
  const Box& influence = probe.influenceBox();
  const glm::dvec3 center = probe.box.center();
  const glm::dmat3 probeFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 skin = 1e-4 * influence.size();
  const auto weighs = [&](const glm::dvec3& low, const glm::dvec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
      // With a blend distance a face itself has no weight; without one it counts as inside.
      const bool soft = probe.blendDistance.min[axis] > 0.0 || probe.blendDistance.max[axis] > 0.0;
      const double margin =
          soft ? 1e-3 * std::min(probe.blendDistance.min[axis], probe.blendDistance.max[axis]) : -skin[axis];
      if (high[axis] < influence.min[axis] + margin || low[axis] > influence.max[axis] - margin) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < actors.size(); ++i) {
    vtkActor* actor = actors[i].actor;
    if (!shadedPhysically(actor)) continue;
    const Box bounds = boxOf(actors[i].state.bounds);
    if (bounds.min.x > bounds.max.x) continue;
    const Box reach = influenceBounds(probe);
    if (glm::any(glm::greaterThan(bounds.min, reach.max)) || glm::any(glm::lessThan(bounds.max, reach.min))) continue;
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    vtkPolyData* data = mapper != nullptr ? mapper->GetInput() : nullptr;
    if (data == nullptr) return true;  // other mappers' cells are not looked at
    const auto part = parts.find(actor);
    const double* m = part != parts.end() ? part->second.matrix.data() : actor->GetMatrix()->GetData();
    for (vtkCellArray* cells : {data->GetPolys(), data->GetStrips(), data->GetLines()}) {
      const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
      for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cell->GetCurrentCell(count, ids);
        glm::dvec3 low(1e300), high(-1e300);
        for (vtkIdType k = 0; k < count; ++k) {
          double p[3];
          data->GetPoint(ids[k], p);
          glm::dvec3 world;
          for (int axis = 0; axis < 3; ++axis) {
            world[axis] = m[4 * axis] * p[0] + m[4 * axis + 1] * p[1] + m[4 * axis + 2] * p[2] + m[4 * axis + 3];
          }
          const glm::dvec3 at = center + probeFromWorld * (world - center);
          low = glm::min(low, at);
          high = glm::max(high, at);
        }
        if (count > 0 && weighs(low, high)) return true;
      }
    }
  }
  return false;
}

void ActorParts::remarkUnreached() {
  for (std::size_t i = 0; i < content.scene.probes.size(); ++i) {
    if (reaches(i)) continue;
    remarks.push_back("probe \"" + content.scene.probes[i].name +
                      "\" lights nothing: no physically shaded surface lies within its influence box, blend distance "
                      "apart; make the box larger or the blend distance 0");
  }
}

// An actor in view that is drawn without its pass: by a mapper that asks for none, or by other keys than its own.
void ActorParts::remarkUnasked() {
  constexpr int kPatience = 3;
  for (LitActor& lit : actors) {
    if (lit.pass->HasRun() || lit.framesWithout > kPatience || parts.count(lit.actor) != 0) continue;
    const bool drawn = lit.actor->GetVisibility() != 0 && lit.actor->GetRenderTimeMultiplier() > 0.0 &&
                       shadedPhysically(lit.actor) && renderer->HasViewProp(lit.actor) != 0;
    if (!drawn) continue;
    auto* mapper = vtkPolyDataMapper::SafeDownCast(lit.actor->GetMapper());
    if (mapper == nullptr || mapper->GetInput() == nullptr || mapper->GetInput()->GetNumberOfCells() == 0) continue;
    if (++lit.framesWithout != kPatience) continue;
    remarks.push_back(std::string("an actor under a ") + mapper->GetClassName() +
                      " reflects nothing: nobody asks for the render passes among its property keys");
  }
}

std::string ActorParts::contentKey() {
  ContentHash hash;
  hash.add(static_cast<double>(skyWanted)).add(state->exposure()).add(static_cast<double>(state->resources.emission));
  hash.add(static_cast<double>(state->resources.lightForm));
  for (const DrawnObject& object : content.objects) {
    vtkActor* actor = object.actor;
    if (!object.settings.seenByProbes || actor->GetVisibility() == 0) continue;
    addAddress(hash, actor);
    const auto part = parts.find(actor);
    if (part != parts.end()) {
      addNumbers(hash, part->second.matrix.data(), 16);
      hash.add(static_cast<double>(part->second.owner->GetVisibility()));
    } else {
      addNumbers(hash, actor->GetMatrix()->GetData(), 16);
    }
    addProperty(hash, actor->GetProperty());
    if (vtkTexture* texture = actor->GetTexture()) hash.add(static_cast<double>(texture->GetMTime()));
    vtkMapper* mapper = actor->GetMapper();
    addAddress(hash, mapper);
    if (mapper == nullptr) continue;
    hash.add(static_cast<double>(mapper->GetMTime()));
    for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port) {
      if (mapper->GetNumberOfInputConnections(port) == 0) continue;
      if (vtkAlgorithm* source = mapper->GetInputAlgorithm(port, 0)) source->Update();
      if (vtkDataObject* data = mapper->GetInputDataObject(port, 0)) hash.add(static_cast<double>(data->GetMTime()));
    }
  }
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* lamp = lights->GetNextLight(it)) {
    if (lamp->GetSwitch() != 0) addLight(hash, lamp);
  }
  return hash.text();
}

std::string ActorParts::probeKey(std::size_t index) const {
  const Probe& probe = content.scene.probes[index];
  const CaptureSettings settings = clippedSettings(index);
  ContentHash hash;
  hash.addVector(probe.origin).addVector(probe.rotationDegrees);
  hash.add(settings.nearDistance).add(settings.farDistance).add(static_cast<double>(probe.faceSize));
  hash.add(static_cast<double>(probe.bounces)).add(static_cast<double>(probe.filter == FilterKind::Gaussian));
  hash.add(static_cast<double>(probe.samplesPerPixel)).add(static_cast<double>(probe.filterSamples));
  hash.add(static_cast<double>(probe.clear.index()));
  if (const auto* color = std::get_if<glm::vec3>(&probe.clear)) hash.addVector(*color);
  return hash.text();
}

bool ActorParts::stale(std::size_t index, const std::string& contentNow) const {
  const CapturedFrom& from = captured[index];
  return !from.given && (from.content != contentNow || from.probe != probeKey(index));
}

bool ActorParts::anyStale() {
  if (nothing) return false;
  refreshSky();
  place();
  assign();
  if (skyStale() || work) return true;
  const std::string now = contentKey();
  for (std::size_t i = 0; i < captured.size(); ++i) {
    if (stale(i, now)) return true;
  }
  return false;
}

bool ActorParts::begin(bool all) {
  if (!all && !anyStale()) return false;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  try {
    makeCurrent(window, graphics != nullptr && graphics->window == window);
    ready();
  } catch (const WorkError& failure) {
    state->counts.fail(failure.what());
    return false;
  }
  dropWork();
  remarks.clear();
  refreshSky();
  // The light that VTK would make in the first frame; lights that follow the camera stand where it is now.
  vtkLightCollection* lights = renderer->GetLights();
  if (lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation()) renderer->CreateLight();
  renderer->UpdateLightsGeometryToFollowCamera();
  captureLights.clear();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* lamp = lights->GetNextLight(it)) {
    if (lamp->GetSwitch() != 0) captureLights.push_back(standing(lamp));
  }
  if (captureLights.empty()) {  // VTK shades nothing physically without one
    captureLights.push_back(vtkSmartPointer<vtkLight>::New());
    captureLights.back()->SetLightTypeToHeadlight();
    captureLights.back()->SetIntensity(0.0);
  }
  place();
  assign();
  remarkUnreached();

  auto planned = std::make_unique<CaptureWork>();
  planned->contentKey = contentKey();
  planned->units = skyStale() ? BakeRunner::units(kSkyFaceSize, false) : 0;
  for (std::size_t i = 0; i < captured.size(); ++i) {
    if (!all && !stale(i, planned->contentKey)) continue;
    planned->probes.push_back(i);
    captured[i].nearDistance = 0.0;
    captured[i].nearDistance = clippedSettings(i).nearDistance;
    planned->probeKeys.push_back(probeKey(i));
    const Probe& probe = content.scene.probes[i];
    planned->bounces = std::max(planned->bounces, probe.bounces);
    planned->units += probe.bounces * BakeRunner::units(probe.faceSize, false);
  }
  if (planned->probes.empty() && !skyStale()) return false;
  planned->made.resize(captured.size());
  work = std::move(planned);
  return true;
}

// Each probe sees the others, and itself, as of the bounce before.
void ActorParts::finishBounce() {
  for (std::size_t i = 0; i < work->made.size(); ++i) {
    if (work->made[i]) shownProbes.show(i, std::move(work->made[i]));
    work->made[i] = nullptr;
  }
  probesChanged();
  assign();
}

void ActorParts::startNext(Graphics& with) {
  if (skyStale()) {
    captureSky(with);
    if (with.runner.pending()) return;
  }
  const std::vector<Probe>& probes = content.scene.probes;
  for (;;) {
    while (work->next < work->probes.size() && work->bounce > probes[work->probes[work->next]].bounces) ++work->next;
    if (work->next < work->probes.size()) break;
    finishBounce();
    if (++work->bounce > work->bounces) {
      for (std::size_t k = 0; k < work->probes.size(); ++k) {
        CapturedFrom& from = captured[work->probes[k]];
        from = {work->contentKey, work->probeKeys[k], false, from.nearDistance};
      }
      work.reset();
      return;
    }
    work->next = 0;
  }
  const std::size_t i = work->probes[work->next++];
  const bool sky = std::holds_alternative<ClearToSky>(probes[i].clear);
  BakeItem item;
  item.settings = clippedSettings(i);
  item.prefilter = prefilterSettings(probes[i]);
  item.faceSize = probes[i].faceSize;
  item.bounce = work->bounce;
  item.reflectNothing = work->bounce == 1;
  if (std::holds_alternative<ClearToOpen>(probes[i].clear)) item.drawing = shownProbes.withoutSky({});
  item.face = [this, sky](int) { return everythingSeen(sky); };
  item.publish = [this, i](std::shared_ptr<const ProbeMaps> maps) { work->made[i] = std::move(maps); };
  with.runner.start(std::move(item));
}

bool ActorParts::step() {
  if (!work) return false;
  vtkRenderer* const before = state->drawing;
  const AtEnd shown([this, before] {
    state->bound.clear();
    state->drawing = before;
  });
  try {
    Graphics& with = ready();
    with.window->MakeCurrent();
    state->drawing = with.capture.renderer();
    if (!with.runner.pending()) startNext(with);
    if (work && with.runner.pending()) {
      with.runner.step();
      ++work->done;
    }
    if (work && !with.runner.pending()) startNext(with);
    if (progress) progress(work ? std::min(1.0, static_cast<double>(work->done) / std::max(work->units, 1)) : 1.0);
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
    // Not tried again before something changes.
    for (std::size_t k = 0; work && k < work->probes.size(); ++k) {
      CapturedFrom& from = captured[work->probes[k]];
      from = {work->contentKey, work->probeKeys[k], false, from.nearDistance};
    }
    dropWork();
  }
  return work != nullptr;
}

void ActorParts::dropWork() {
  if (work && graphics) graphics->runner.abort();
  work.reset();
}

void ActorParts::release() {
  state->bound.clear();
  shownProbes.release();
  skyShown = 0;
  for (CapturedFrom& from : captured) from = {};
  work.reset();
  if (!graphics) return;
  static_cast<ContextWatch*>(contextWatch.Get())->Lost = nullptr;
  graphics->window->MakeCurrent();
  graphics->runner.release();
  graphics->capture.release();
  content.sky->ReleaseGraphicsResources(graphics->window);
  lightSky->ReleaseGraphicsResources(graphics->window);
  releaseStaticTextures(state->resources);
  graphics.reset();
  for (LitActor& lit : actors) lit.pass->Rebuild();
}

}  // namespace boxprobe
