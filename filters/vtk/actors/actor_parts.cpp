#include "filters/vtk/actors/actor_parts.h"

#include <vtkAssemblyPath.h>
#include <vtkCamera.h>
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

#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/vtk/draw/static_textures.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

constexpr const char* kNoContext =
    "the render window has no OpenGL context yet; show its widget first, or leave the capture to the first Render()";

/// A texture without memory: VTK's windows notify textures, and nothing else, before the context is destroyed.
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

/// Reads what determines which probes light an actor, and by which program. Returns whether it changed.
bool follow(DrawnObject& object, const std::array<double, 6>* placedBounds) {
  vtkActor* actor = object.actor;
  std::array<double, 6> b{};
  if (placedBounds != nullptr) {
    b = *placedBounds;
  } else if (const double* own = actor->GetBounds()) {
    std::copy(own, own + 6, b.begin());
  }
  const Box bounds{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
  vtkProperty* property = actor->GetProperty();
  const bool textured = property->GetTexture("materialTex") != nullptr;
  double roughnessMin = textured ? 0.0 : property->GetRoughness(), roughnessMax = property->GetRoughness();
  if (property->GetCoatStrength() > 0.0) {
    roughnessMin = std::min(roughnessMin, property->GetCoatRoughness());
    roughnessMax = std::max(roughnessMax, property->GetCoatRoughness());
  }
  const bool allMetal = property->GetMetallic() == 1.0 && !textured;
  const bool same = object.placedBounds && object.placedBounds->min == bounds.min &&
                    object.placedBounds->max == bounds.max && object.roughnessMin == roughnessMin &&
                    object.roughnessMax == roughnessMax && object.allMetal == allMetal;
  object.placedBounds = bounds;
  object.roughnessMin = roughnessMin;
  object.roughnessMax = roughnessMax;
  object.allMetal = allMetal;
  return !same;
}

/// A light for captures at the current position of the renderer's light: captures must not move lights that follow its
/// camera.
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

/// Null: does nothing. Initializes a widget's window unless it has `begun`, since it may not have drawn yet. Throws
/// WorkError without a context.
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

// Hashes values instead of the modification time: a program may set the same colour in every frame.
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
  if (light->LightTypeIsHeadlight()) return;  // at the camera
  addNumbers(hash, light->GetPosition(), 3);
  addNumbers(hash, light->GetFocalPoint(), 3);
}

bool empty(const Box& box) {
  return box.min.x > box.max.x;
}

}  // namespace

ActorParts::ActorParts(vtkRenderer* shown)
    : renderer(shown != nullptr ? vtkSmartPointer<vtkRenderer>(shown) : vtkSmartPointer<vtkRenderer>::New()),
      nothing(shown == nullptr),
      state(std::make_shared<DrawState>()),
      probes(&content, state, &captured),
      frames(renderer, state, &content, [this] { return picturedProps(); }) {
  state->resources.foreign = true;
  state->resources.tone = Tone::AsVtk;
  state->resources.emission = false;
  content.scene.sky = SkyColor{};
  content.sky->SetDrawState(state);
  content.skyLight = lightSky;
  lightSky->SetDrawState(state);
  state->shown = renderer;
  observer->SetClientData(this);
  observer->SetCallback([](vtkObject* caller, unsigned long event, void* client, void*) {
    auto* all = static_cast<ActorParts*>(client);
    event == vtkCommand::StartEvent ? all->starts(caller) : all->endFrame(caller);
    if (event == vtkCommand::EndEvent && caller == all->renderer && all->afterFrame) all->afterFrame();
  });
  refreshSky();
  observeWindow();
}

ActorParts::~ActorParts() {
  for (const auto& one : observed) {
    if (one != nullptr) one->RemoveObserver(observer);
  }
  for (DrawnObject& object : content.objects) object.pass->Detach();
  release();
}

// Any renderer of the window may show the actors: each draws them with its own camera.
void ActorParts::observeWindow() {
  vtkRenderWindow* shownIn = renderer->GetRenderWindow();
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
  observedWindow = shownIn;
  if (shownIn == nullptr) return;
  observe(shownIn, false);
  vtkCollectionSimpleIterator it;
  vtkRendererCollection* all = shownIn->GetRenderers();
  all->InitTraversal(it);
  while (vtkRenderer* one = all->GetNextRenderer(it)) more |= observe(one, true);
  if (!more) return;
  for (DrawnObject& object : content.objects) object.pass->RebuildIfPlain();
}

void ActorParts::starts(vtkObject* caller) {
  auto* drawn = vtkRenderer::SafeDownCast(caller);
  const bool first = drawn == renderer && observedWindow != renderer->GetRenderWindow();
  if (drawn == nullptr || first) {
    observeWindow();
    if (beforeFrame) beforeFrame();
    // A renderer that is drawn first may show the same actors.
    place();
    assign();
  }
  if (drawn != nullptr) beginFrame(drawn);
}

void ActorParts::ready() {
  if (nothing) throw InputError("probes need a renderer; they were made with a null one");
  auto* shownIn = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (shownIn == nullptr) {
    throw InputError("probes need a renderer in a vtkOpenGLRenderWindow; call the window's AddRenderer() first");
  }
  if (waitsForContext(shownIn)) throw WorkError(kNoContext);
  if (window != shownIn) {
    release();
    window = shownIn;
    probes.baker().setWindow(window);
    frames.setWindow(window);
    const auto watch = vtkSmartPointer<ContextWatch>::New();
    watch->Lost = [this] { release(); };
    watch->SetContext(window);
    contextWatch = watch;
  }
  makeStaticTextures(window, state->resources, state->counts);
}

void ActorParts::beginFrame(vtkRenderer* drawn) {
  state->drawing = drawn;
  try {
    ready();
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
    state->drawing = nullptr;  // until the next frame, actors have VTK's own programs
    for (DrawnObject& object : content.objects) object.pass->Rebuild();
    return;
  }
  // A selector's colours are no picture.
  const bool selecting = drawn->GetSelector() != nullptr;
  vtkOpenGLState* gl = window->GetState();
  seamlessBefore = gl->GetEnumState(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  refreshSky();
  showDarkSky();
  if (drawn == renderer) {
    place();
    assign();
  }
  if (refineTo.rays > 0) {
    if (drawn == renderer && !selecting) {
      followPicture();
    } else if (refining && (selecting || showsAny(drawn))) {
      frames.dropRays();
    }
  }
  for (DrawnObject& object : content.objects) object.pass->RebuildIfPlain();
}

// A picture that differs from the last is drawn as the techniques draw it, and refined once somebody asks again.
void ActorParts::followPicture() {
  std::string now = pictureKey();
  if (now != pictureShown) {
    pictureShown = std::move(now);
    ++pictures;
    stopRefining();
  }
  if (refining) frames.beginFrame(false, working);
}

void ActorParts::stopRefining() {
  if (!refining) return;
  refining = false;
  frames.refine({});
}

bool ActorParts::showsAny(vtkRenderer* drawn) const {
  return std::any_of(content.objects.begin(), content.objects.end(), [&](const DrawnObject& object) {
    const auto part = parts.find(object.actor);
    vtkProp* prop = part != parts.end() ? part->second.owner : object.actor.Get();
    return drawn->HasViewProp(prop) != 0;
  });
}

std::vector<vtkProp*> ActorParts::picturedProps() const {
  // Other curves than these two have no inverse, so what is not lit by them is drawn over the picture.
  const bool all = state->resources.tone == Tone::AsVtk || state->resources.tone == Tone::None;
  std::vector<vtkProp*> props;
  std::set<vtkProp*> taken;
  for (const DrawnObject& object : content.objects) {
    if (!all && !shadedPhysically(object.actor)) continue;
    const auto part = parts.find(object.actor);
    vtkProp* prop = part != parts.end() ? part->second.owner : object.actor.Get();
    if (taken.insert(prop).second) props.push_back(prop);
  }
  return props;
}

std::string ActorParts::refusedRefinement() const {
  const bool peels = renderer->GetUseDepthPeeling() != 0 &&
                     std::any_of(content.objects.begin(), content.objects.end(), [](const DrawnObject& object) {
                       return object.actor->HasTranslucentPolygonalGeometry() != 0;
                     });
  const char* what = renderer->GetPass() != nullptr ? "a render pass of its own"
                     : renderer->GetUseSSAO()       ? "ambient occlusion (UseSSAO)"
                     : renderer->GetUseFXAA()       ? "smoothed edges (UseFXAA)"
                     : renderer->GetUseShadows()    ? "shadows (UseShadows)"
                     : peels                        ? "peeled layers (UseDepthPeeling)"
                                                    : nullptr;
  return what == nullptr ? std::string()
                         : std::string("the picture is not refined: its renderer has ") + what +
                               ", which the averaged frames would go without";
}

std::string ActorParts::pictureKey() const {
  ContentHash hash;
  for (const DrawnObject& object : content.objects) {
    vtkActor* actor = object.actor;
    const auto part = parts.find(actor);
    const bool shown = actor->GetVisibility() != 0 && (part == parts.end() || part->second.owner->GetVisibility() != 0);
    hash.add(shown ? drawnKey(object) : std::string());
  }
  hash.add(lightsKey()).add(static_cast<double>(skies)).add(static_cast<double>(state->resources.tone));
  // As floats: vtkWindowToImageFilter sets the view angle anew, and its last bit may differ.
  const auto addFloats = [&](vtkMatrix4x4* matrix, int count) {
    for (int i = 0; i < count; ++i) {
      const auto number = static_cast<float>(matrix->GetData()[i]);
      hash.addBytes(&number, sizeof number);
    }
  };
  vtkCamera* camera = renderer->GetActiveCamera();
  addFloats(camera->GetModelViewTransformMatrix(), 16);
  // Of any clipping distances: they follow what is added to the renderer, and change no colour.
  addFloats(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0), 8);
  int size[4] = {0, 0, 0, 0};
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &size[2], &size[3]);
  hash.addBytes(size, sizeof size).add(static_cast<double>(window->GetMultiSamples()));
  hash.add(static_cast<double>(probeChanges));
  return hash.text();
}

bool ActorParts::refineStep() {
  auto* shownIn = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (refineTo.rays <= 0 || shownIn == nullptr || waitsForContext(shownIn) || shownIn->CheckInRenderStatus() != 0) {
    return false;
  }
  if (!refining) {
    if (!refusedRefinement().empty()) return false;
    refining = true;
    frames.refine(refineTo);
  }
  shownIn->Render();
  // Something else was to be shown: that frame is the first of another picture, unless no two are alike.
  restless = refining ? 0 : restless + 1;
  return refining ? working || frames.count().more() : restless < 2;
}

void ActorParts::endFrame(vtkObject* caller) {
  if (caller == renderer) frames.endFrame();
  if (state->drawing == renderer) remarkUnasked();
  state->bound.clear();
  if (!seamlessBefore && state->drawing != nullptr && window != nullptr)
    window->GetState()->vtkglDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state->drawing = nullptr;
}

// Finds which actors other props of the renderer draw, and where; installs the pass among the keys that are drawn with.
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
  for (DrawnObject& object : content.objects) {
    const auto part = parts.find(object.actor);
    object.pass->Attach(object.actor, part != parts.end() ? part->second.owner : object.actor.Get());
  }
}

void ActorParts::assign() {
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < content.objects.size(); ++i) {
    const auto part = parts.find(content.objects[i].actor);
    if (follow(content.objects[i], part != parts.end() ? &part->second.bounds : nullptr)) changed.push_back(i);
  }
  if (!assigned) probes.binder().assign();
  for (std::size_t k = 0; assigned && k < changed.size(); ++k) probes.binder().assign(changed[k]);
  assigned = true;
}

void ActorParts::probesChanged(const ProbeEntries::Origins& origins) {
  std::vector<double> near;
  for (const auto& origin : origins) near.push_back(origin ? nearDistances[*origin] : 0.0);
  nearDistances = std::move(near);
  dropWork();
  captured.probes = content.scene.probes;
  probes.updateShapes(origins);
  planned.reset();
  assigned = false;
  ++probeChanges;
}

void ActorParts::probesChanged() {
  ++probeChanges;
  probes.binder().updateShapes();
  planned.reset();
  assigned = false;
}

// With a given sky, captures see what lights; else they also see the background, which gives no light.
void ActorParts::refreshSky() {
  if (skyGiven) return;
  if (!surroundings.read(renderer, state->resources.tone)) return;
  state->counts.fail(surroundings.problem());
  const OrientedSky& backdrop = surroundings.backdrop();
  content.sky->SetSky(backdrop.sky, 0.0, backdrop.image);
  content.sky->SetSkyFromWorld(backdrop.pictureFromWorld);
  if (const OrientedSky* lit = surroundings.light()) {
    lightSky->SetSky(lit->sky, 0.0, lit->image);
    lightSky->SetSkyFromWorld(lit->pictureFromWorld);
  }
  ++skies;
}

// Available at once, because no light needs no filtering.
void ActorParts::showDarkSky() {
  if (skyGiven || surroundings.light() != nullptr || state->resources.sky == nullptr) return;
  probes.plan().skyShows({});
  probes.binder().showSky(nullptr);
}

// Captures use the renderer's lights at their current positions. Creates the light that VTK would create in the first
// frame.
void ActorParts::setCaptureLights() {
  vtkLightCollection* lights = renderer->GetLights();
  if (lights->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation()) renderer->CreateLight();
  renderer->UpdateLightsGeometryToFollowCamera();
  content.lights.clear();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* lamp = lights->GetNextLight(it)) {
    if (lamp->GetSwitch() != 0) content.lights.push_back(standing(lamp));
  }
  if (!content.lights.empty()) return;
  content.lights.push_back(vtkSmartPointer<vtkLight>::New());  // without a light VTK shades nothing physically
  content.lights.back()->SetLightTypeToHeadlight();
  content.lights.back()->SetIntensity(0.0);
}

// Values that are not set are derived from the box and the visible scene: a room may be a millimetre or a kilometre
// wide.
void ActorParts::clipCaptures() {
  captured.probes = content.scene.probes;
  nearDistances.resize(captured.probes.size());
  const Probe standard;
  for (std::size_t i = 0; i < captured.probes.size(); ++i) {
    Probe& probe = captured.probes[i];
    if (probe.nearDistance == standard.nearDistance) {
      const glm::dvec3 half = 0.5 * probe.box.size();
      const double smallest = std::min({half.x, half.y, half.z}), largest = std::max({half.x, half.y, half.z});
      double nearest = 0.0025 * (smallest > 0.0 ? smallest : std::max(largest, 1e-30));
      if (largest <= 0.0) nearest = standard.nearDistance;
      constexpr double kKept = 8.0;  // keep the distances of a box this many times smaller or larger
      const double kept = nearDistances[i];
      probe.nearDistance = kept > nearest / kKept && kept < nearest * kKept ? kept : nearest;
      nearDistances[i] = probe.nearDistance;
    }
    if (probe.farDistance == standard.farDistance) {
      double farthest = 0.0;
      for (const DrawnObject& object : content.objects) {
        const Box b = worldBounds(object);
        if (!object.settings.seenByProbes || empty(b)) continue;
        const glm::dvec3 reach = glm::max(glm::abs(b.min - probe.origin), glm::abs(b.max - probe.origin));
        farthest = std::max(farthest, glm::length(reach));
      }
      probe.farDistance = std::max(1.01 * farthest, 1000.0 * probe.nearDistance);
    }
  }
}

// Compares an upper bound of the probe's weight over each cell's bounds: exact for cells parallel to the box's axes.
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
  for (const DrawnObject& object : content.objects) {
    vtkActor* actor = object.actor;
    if (!shadedPhysically(actor)) continue;
    const Box bounds = worldBounds(object);
    if (empty(bounds)) continue;
    const Box reach = influenceBounds(probe);
    if (glm::any(glm::greaterThan(bounds.min, reach.max)) || glm::any(glm::lessThan(bounds.max, reach.min))) continue;
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    vtkPolyData* data = mapper != nullptr ? mapper->GetInput() : nullptr;
    if (data == nullptr) return true;  // cells of other mappers are not examined
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

// Warns of an actor in view that was drawn without its pass: by a mapper that ignores passes, or with keys other than
// its own.
void ActorParts::remarkUnasked() {
  constexpr int kPatience = 3;
  for (const DrawnObject& object : content.objects) {
    vtkActor* actor = object.actor;
    if (object.pass->HasRun() || framesWithout[actor] > kPatience || parts.count(actor) != 0) continue;
    const bool drawn = actor->GetVisibility() != 0 && actor->GetRenderTimeMultiplier() > 0.0 &&
                       shadedPhysically(actor) && renderer->HasViewProp(actor) != 0;
    if (!drawn) continue;
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    if (mapper == nullptr || mapper->GetInput() == nullptr || mapper->GetInput()->GetNumberOfCells() == 0) continue;
    if (++framesWithout[actor] != kPatience) continue;
    remarks.push_back(std::string("an actor under a ") + mapper->GetClassName() +
                      " reflects nothing: nobody asks for the render passes among its property keys");
  }
}

// Empty if captures do not show the object.
std::string ActorParts::objectKey(const DrawnObject& object) const {
  if (!object.settings.seenByProbes || object.actor->GetVisibility() == 0) return {};
  const auto part = parts.find(object.actor);
  if (part != parts.end() && part->second.owner->GetVisibility() == 0) return {};
  return drawnKey(object);
}

std::string ActorParts::drawnKey(const DrawnObject& object) const {
  vtkActor* actor = object.actor;
  ContentHash hash;
  addAddress(hash, actor);
  const auto part = parts.find(actor);
  if (part != parts.end()) {
    addNumbers(hash, part->second.matrix.data(), 16);
  } else {
    addNumbers(hash, actor->GetMatrix()->GetData(), 16);
  }
  addProperty(hash, actor->GetProperty());
  if (vtkTexture* texture = actor->GetTexture()) hash.add(static_cast<double>(texture->GetMTime()));
  vtkMapper* mapper = actor->GetMapper();
  addAddress(hash, mapper);
  if (mapper == nullptr) return hash.text();
  hash.add(static_cast<double>(mapper->GetMTime()));
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port) {
    if (mapper->GetNumberOfInputConnections(port) == 0) continue;
    if (vtkAlgorithm* source = mapper->GetInputAlgorithm(port, 0)) source->Update();
    if (vtkDataObject* data = mapper->GetInputDataObject(port, 0)) hash.add(static_cast<double>(data->GetMTime()));
  }
  return hash.text();
}

std::string ActorParts::lightsKey() const {
  ContentHash hash;
  hash.add(state->exposure()).add(static_cast<double>(state->resources.emission));
  hash.add(static_cast<double>(state->resources.lightForm)).add(state->resources.tone == Tone::AsVtk ? 1.0 : 0.0);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* lamp = lights->GetNextLight(it)) {
    if (lamp->GetSwitch() != 0) addLight(hash, lamp);
  }
  return hash.text();
}

ShownContent ActorParts::shownContent() {
  ShownContent shown;
  for (const DrawnObject& object : content.objects) shown.objects.push_back(objectKey(object));
  shown.lights = lightsKey();
  shown.sky = skies;
  return shown;
}

CaptureInputs ActorParts::captureInputs() {
  CaptureInputs inputs;
  std::vector<PlacedObject> objects;
  for (std::size_t i = 0; i < content.objects.size(); ++i) {
    const DrawnObject& drawn = content.objects[i];
    PlacedObject object;
    object.contentKey = planned->objects[i];
    object.boundsWorld = worldBounds(drawn);
    object.seenByProbes = !object.contentKey.empty() && !empty(object.boundsWorld);
    if (empty(object.boundsWorld)) object.boundsWorld = Box{};
    object.unlit = !shadedPhysically(drawn.actor);
    objects.push_back(std::move(object));
    const auto part = parts.find(drawn.actor);
    inputs.props.emplace_back(part != parts.end() ? part->second.owner : drawn.actor.Get());
  }
  inputs.world = captureWorld(captured, objects, {}, probes.plan().entries().places());
  const std::string sky = "sky " + std::to_string(planned->sky);
  inputs.world.sky = sky;
  inputs.world.lights = planned->lights;
  const OrientedSky* light = skyGiven ? nullptr : surroundings.light();
  if (skyGiven || light != nullptr) inputs.sky = sky;
  const auto& image = skyGiven ? content.skyImage : light != nullptr ? light->image : nullptr;
  if (image) inputs.skyColumns = image->width;
  return inputs;
}

// Compares nothing during captures: they show the scene as it was when they were planned, so that something in constant
// motion is shown late instead of never.
bool ActorParts::anyStale() {
  if (nothing) return false;
  if (working) return true;
  refreshSky();
  place();
  assign();
  ShownContent now = shownContent();
  if (!planned || !(*planned == now)) {
    planned = std::move(now);
    clipCaptures();
    ProbeEntries::Origins same;
    for (std::size_t i = 0; i < captured.probes.size(); ++i) same.emplace_back(i);
    probes.plan().entries().follow(same);
    probes.updateCaptures(captureInputs());
    showDarkSky();
  }
  return window == nullptr || probes.workPending();  // before the first frame the amount of work is unknown
}

bool ActorParts::begin(bool all) {
  if (!all && !anyStale()) return false;
  auto* shownIn = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  try {
    makeCurrent(shownIn, window != nullptr && window == shownIn);
    ready();
  } catch (const WorkError& failure) {
    state->counts.fail(failure.what());
    return false;
  }
  dropWork();
  remarks.clear();
  setCaptureLights();
  anyStale();
  remarkUnreached();
  if (all) {
    std::vector<std::string> names;
    for (const Probe& probe : content.scene.probes) names.push_back(probe.name);
    probes.requestBake(names);
    probes.updateCaptures(captureInputs());
  }
  working = probes.workPending();
  return working;
}

bool ActorParts::step() {
  if (!working) return false;
  vtkRenderer* const before = state->drawing;
  const ScopeExit shown([this, before] {
    state->bound.clear();
    state->drawing = before;
  });
  try {
    ready();
    window->MakeCurrent();
    state->drawing = probes.baker().capture()->renderer();
    probes.step();
    state->counts.fail(probes.plan().memoryError());
    working = probes.workPending();
    if (progress) progress(probes.progress());
  } catch (const Error& failure) {
    state->counts.fail(failure.what());
    probes.cancelWork();  // not repeated before something changes
    working = false;
  }
  return working;
}

void ActorParts::dropWork() {
  if (!working) return;
  probes.cancelWork();
  planned.reset();
  working = false;
}

void ActorParts::release() {
  state->bound.clear();
  planned.reset();
  working = false;
  std::fill(nearDistances.begin(), nearDistances.end(), 0.0);
  if (window == nullptr) return;
  static_cast<ContextWatch*>(contextWatch.Get())->Lost = nullptr;
  window->MakeCurrent();
  refining = false;
  pictureShown.clear();
  frames.refine({});
  frames.release();
  probes.release();
  probes.baker().setWindow(nullptr);
  frames.setWindow(nullptr);
  content.sky->ReleaseGraphicsResources(window);
  lightSky->ReleaseGraphicsResources(window);
  releaseStaticTextures(state->resources);
  window = nullptr;
  for (DrawnObject& object : content.objects) object.pass->Rebuild();
}

}  // namespace boxprobe
