#include "filters/vtk/scene_renderer.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "filters/io/image_file.h"
#include "filters/vtk/bake_queue.h"
#include "filters/vtk/brdf_table.h"
#include "filters/vtk/capture_key.h"
#include "filters/vtk/cube_capture.h"
#include "filters/vtk/model_actors.h"
#include "filters/vtk/probe_assignment.h"
#include "filters/vtk/scene_lights.h"
#include "filters/vtk/vtkSkyProp.h"

namespace boxprobe {

namespace {

// Maps no probe uses any more are kept for undo up to this much GPU memory.
constexpr std::size_t kMapCacheBytes = std::size_t{256} << 20;
constexpr int kSkyFaceSize = 64;
constexpr int kSkyImageFaceSize = 256;

int samplesPerSide(int samplesPerPixel) { return samplesPerPixel >= 16 ? 4 : samplesPerPixel >= 4 ? 2 : 1; }

}  // namespace

struct SceneRenderer::Impl {
  explicit Impl(vtkOpenGLRenderWindow* w)
      : window(w), state(std::make_shared<DrawState>()), capture(w, state), queue(w, state, &capture, &times) {}

  vtkOpenGLRenderWindow* window;
  std::shared_ptr<DrawState> state;
  Times times;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkSkyProp> sky;
  vtkNew<vtkCallbackCommand> frameObserver;
  CubeCapture capture;
  BakeQueue queue;

  Scene scene;
  std::vector<std::shared_ptr<const Model>> models;
  int modelGeneration = 0;
  std::vector<DrawnObject> objects;
  std::vector<vtkSmartPointer<vtkLight>> lights;
  bool probesEnabled = true;
  bool interactive = false;

  std::vector<std::string> probeNames;  ///< as `drawn` is ordered
  std::vector<std::shared_ptr<DrawnProbe>> drawn;
  std::vector<std::string> wanted, shown;  ///< capture keys by probe
  std::string wantedSky, shownSky;
  struct CachedMaps {
    std::string key;
    std::shared_ptr<const ProbeMaps> maps;
  };
  std::vector<CachedMaps> cache;  ///< most recently made last
  std::vector<std::string> queued;  ///< keys the queue is working towards
  std::set<std::string> variantsUsed;
  bool bindingsPostponed = false;

  std::shared_ptr<const ImageRgbaF> skyImage;
  std::string skyImageFile;

  void rebuildObjects();
  void updateLights();
  void updateSky();
  void updateProbes(bool listChanged);
  void updateBindings();
  void updateKeys();
  void startWork();
  bool stale() const;
  std::vector<BakeItem> staleItems();
  std::vector<vtkProp*> seenProps(const Probe& probe);
  std::shared_ptr<const ProbeMaps> cached(const std::string& key) const;
  void remember(const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  void makeResources();
  void beginFrame();
  Box bounds() const;
  std::vector<vtkLight*> lightPointers() const;
};

// ---------------------------------------------------------------- scene to VTK

void SceneRenderer::Impl::rebuildObjects() {
  for (DrawnObject& object : objects) renderer->RemoveActor(object.actor);
  objects.clear();
  ++modelGeneration;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    for (DrawnObject& object : makeObjects(*models[i], scene.models[i], state)) {
      renderer->AddActor(object.actor);
      objects.push_back(std::move(object));
    }
  }
  // Drawn last: it only fills what nothing else covered.
  renderer->RemoveViewProp(sky);
  renderer->AddViewProp(sky);
}

void SceneRenderer::Impl::updateLights() {
  renderer->RemoveAllLights();
  lights = makeLights(scene, bounds().center());
  for (auto& light : lights) renderer->AddLight(light);
}

void SceneRenderer::Impl::updateSky() {
  const auto* image = std::get_if<SkyImage>(&scene.sky);
  if (image == nullptr) {
    skyImage.reset();
    skyImageFile.clear();
  } else if (image->file != skyImageFile) {
    skyImage = std::make_shared<ImageRgbaF>(loadHdrImage(image->file));
    skyImageFile = image->file;
  }
  sky->SetSky(scene.sky, skyImage);
}

Box SceneRenderer::Impl::bounds() const {
  Box box;
  bool any = false;
  for (const DrawnObject& object : objects) {
    if (!object.settings.visible) continue;
    const Box b = worldBounds(object);
    box = any ? Box{glm::min(box.min, b.min), glm::max(box.max, b.max)} : b;
    any = true;
  }
  return box;
}

// ---------------------------------------------------------------- probes

void SceneRenderer::Impl::updateProbes(bool listChanged) {
  if (listChanged) {
    // A probe keeps what it shows through a change of the list; a renamed one finds its maps again by key.
    std::vector<std::shared_ptr<DrawnProbe>> next;
    std::vector<std::string> names, keys;
    for (const Probe& probe : scene.probes) {
      const auto it = std::find(probeNames.begin(), probeNames.end(), probe.name);
      const auto index = static_cast<std::size_t>(it - probeNames.begin());
      next.push_back(it != probeNames.end() ? drawn[index] : std::make_shared<DrawnProbe>());
      keys.push_back(it != probeNames.end() ? shown[index] : std::string());
      names.push_back(probe.name);
    }
    drawn = std::move(next);
    probeNames = std::move(names);
    shown = std::move(keys);
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Probe& probe = scene.probes[i];
    drawn[i]->geometry = probeGeometry(probe, drawn[i]->maps ? drawn[i]->maps->capturedAt : probe.origin);
  }
}

void SceneRenderer::Impl::updateBindings() {
  bindingsPostponed = false;
  for (DrawnObject& object : objects) {
    auto binding = assignProbes(object, scene, drawn, probesEnabled);
    const std::string key = binding->variantKey();
    const bool known = variantsUsed.count(key) > 0;
    const ProbeBinding* current = object.mapper->GetBinding();
    // A box dragged over further objects would need programs that are not compiled yet; that waits for the drag's end.
    if (interactive && !known && current != nullptr && current->variantKey() != key) {
      bindingsPostponed = true;
      continue;
    }
    variantsUsed.insert(key);
    object.mapper->SetBinding(std::move(binding));
  }
}

void SceneRenderer::Impl::updateKeys() {
  const std::string shared = sharedCaptureKey(scene, objects, modelGeneration);
  wanted.clear();
  for (std::size_t i = 0; i < scene.probes.size(); ++i) wanted.push_back(captureKey(scene, i, shared));
  wantedSky = skyKey(scene);
  // What was made before is shown at once: undo, or back to an earlier face size.
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (wanted[i] == shown[i]) continue;
    if (auto maps = cached(wanted[i])) {
      drawn[i]->maps = maps;
      shown[i] = wanted[i];
      drawn[i]->geometry = probeGeometry(scene.probes[i], maps->capturedAt);
    }
  }
  if (wantedSky != shownSky) {
    if (auto maps = cached(wantedSky)) {
      state->sky = maps;
      shownSky = wantedSky;
    }
  }
}

std::shared_ptr<const ProbeMaps> SceneRenderer::Impl::cached(const std::string& key) const {
  for (const CachedMaps& entry : cache) {
    if (entry.key == key) return entry.maps;
  }
  return nullptr;
}

void SceneRenderer::Impl::remember(const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  cache.erase(std::remove_if(cache.begin(), cache.end(), [&](const CachedMaps& c) { return c.key == key; }), cache.end());
  cache.push_back({key, std::move(maps)});
  std::size_t bytes = 0;
  for (const CachedMaps& entry : cache) bytes += entry.maps->bytes();
  for (auto it = cache.begin(); it != cache.end() && bytes > kMapCacheBytes;) {
    if (it->maps.use_count() > 1) {  // a probe shows it
      ++it;
      continue;
    }
    bytes -= it->maps->bytes();
    it = cache.erase(it);
  }
}

// ---------------------------------------------------------------- capture work

bool SceneRenderer::Impl::stale() const {
  if (!probesEnabled) return false;
  const bool anyLit = std::any_of(objects.begin(), objects.end(),
                                  [](const DrawnObject& o) { return !o.unlit && o.settings.visible; });
  if (!anyLit) return false;
  if (wantedSky != shownSky) return true;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == shown[i]) continue;
    for (const DrawnObject& object : objects) {
      if (!object.unlit && object.settings.visible && influenceMeets(scene.probes[i], worldBounds(object))) return true;
    }
  }
  return false;
}

std::vector<vtkProp*> SceneRenderer::Impl::seenProps(const Probe& probe) {
  std::vector<vtkProp*> props;
  for (DrawnObject& object : objects) {
    const bool hidden = std::find(probe.hides.begin(), probe.hides.end(), object.node) != probe.hides.end();
    if (object.settings.seenByProbes && !hidden) props.push_back(object.actor);
  }
  if (std::holds_alternative<ClearToSky>(probe.clear)) props.push_back(sky);
  return props;
}

std::vector<vtkLight*> SceneRenderer::Impl::lightPointers() const {
  std::vector<vtkLight*> pointers;
  for (const auto& light : lights) pointers.push_back(light);
  return pointers;
}

std::vector<BakeItem> SceneRenderer::Impl::staleItems() {
  std::vector<BakeItem> items;
  if (wantedSky != shownSky) {
    BakeItem item;
    item.faceSize = skyImage ? kSkyImageFaceSize : kSkyFaceSize;
    item.distance = false;
    item.settings.samplesPerTexelSide = 1;
    item.props = {sky};
    item.publish = [this, key = wantedSky](std::shared_ptr<const ProbeMaps> maps) {
      state->sky = maps;
      shownSky = key;
      remember(key, std::move(maps));
    };
    items.push_back(std::move(item));
  }
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const Probe& probe = scene.probes[i];
    const bool needed = std::any_of(objects.begin(), objects.end(), [&](const DrawnObject& o) {
      return !o.unlit && o.settings.visible && influenceMeets(probe, worldBounds(o));
    });
    if (wanted[i] == shown[i] || !needed) continue;
    BakeItem item;
    item.settings.originWorld = probe.origin;
    item.settings.nearDistance = probe.nearDistance;
    item.settings.farDistance = probe.farDistance;
    item.settings.clear = probe.clear;
    item.settings.samplesPerTexelSide = samplesPerSide(probe.samplesPerPixel);
    item.faceSize = probe.faceSize;
    item.bounces = interactive ? 1 : probe.bounces;
    item.props = seenProps(probe);
    // A capture made during a drag shows at once but does not count as the final one.
    const std::string key = interactive ? wanted[i] + "| during a drag" : wanted[i];
    item.publish = [this, key, name = probe.name, left = std::make_shared<int>(item.bounces)](
                       std::shared_ptr<const ProbeMaps> maps) {
      const auto it = std::find(probeNames.begin(), probeNames.end(), name);
      if (it == probeNames.end()) return;
      const auto index = static_cast<std::size_t>(it - probeNames.begin());
      drawn[index]->maps = maps;
      drawn[index]->geometry = probeGeometry(scene.probes[index], maps->capturedAt);
      if (--*left == 0) {
        shown[index] = key;
        if (key == wanted[index]) remember(key, std::move(maps));
      }
    };
    items.push_back(std::move(item));
  }
  return items;
}

void SceneRenderer::Impl::startWork() {
  if (!stale()) {
    queue.abort();
    queued.clear();
    return;
  }
  std::vector<std::string> target = wanted;
  target.push_back(wantedSky);
  target.emplace_back(interactive ? "interactive" : "still");
  if (queue.pending()) {
    if (target == queued) return;
    // While something is dragged the capture under way is completed first: a picture a little late is better than none.
    if (interactive && queued.back() == "interactive") return;
  }
  queued = target;
  queue.start(staleItems(), lightPointers(), interactive);
}

void SceneRenderer::Impl::makeResources() {
  if (state->brdfTable != 0) return;
  const BrdfTable table = makeBrdfTable();
  glGenTextures(1, &state->brdfTable);
  {
    const BoundTexture bound(window, GL_TEXTURE_2D, state->brdfTable);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, table.columns, table.rows, 0, GL_RG, GL_FLOAT, table.texels.data());
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glGenTextures(1, &state->blackCube);
  const BoundTexture bound(window, GL_TEXTURE_CUBE_MAP, state->blackCube);
  const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA16F, 1, 1, 0, GL_RGBA, GL_FLOAT, black);
  }
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
}

void SceneRenderer::Impl::beginFrame() {
  makeResources();
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state->exposure = static_cast<float>(scene.exposure);
  state->counters.drawsByProbeCount = {};
  renderer->ResetCameraClippingRange();
}

// ---------------------------------------------------------------- public face

SceneRenderer::SceneRenderer(vtkOpenGLRenderWindow* window) : impl_(std::make_unique<Impl>(window)) {
  Impl& d = *impl_;
  d.sky->SetDrawState(d.state);
  d.renderer->AutomaticLightCreationOff();
  d.renderer->SetLightFollowCamera(false);
  d.renderer->SetBackground(0.0, 0.0, 0.0);
  d.frameObserver->SetClientData(&d);
  d.frameObserver->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
    auto* impl = static_cast<Impl*>(client);
    if (event == vtkCommand::StartEvent) {
      impl->beginFrame();
    } else {
      ++impl->state->counters.renders;
    }
  });
  d.renderer->AddObserver(vtkCommand::StartEvent, d.frameObserver);
  d.renderer->AddObserver(vtkCommand::EndEvent, d.frameObserver);
  window->AddRenderer(d.renderer);
}

SceneRenderer::~SceneRenderer() {
  releaseGraphics();
  impl_->renderer->RemoveObserver(impl_->frameObserver);
  impl_->window->RemoveRenderer(impl_->renderer);
}

void SceneRenderer::setModels(std::vector<std::shared_ptr<const Model>> models) {
  impl_->models = std::move(models);
  impl_->modelGeneration++;
}

void SceneRenderer::sync(const Scene& scene, const Changes& changes) {
  Impl& d = *impl_;
  d.scene = scene;
  if (changes.models || changes.file) d.rebuildObjects();
  const bool objects = changes.models || changes.file || changes.materials || changes.objects;
  if (objects) {
    for (DrawnObject& object : d.objects) applyOverrides(object, scene);
  }
  if (changes.models || changes.file || changes.lights) d.updateLights();
  if (changes.sky || changes.file) d.updateSky();
  const bool probes = changes.probeList || changes.probeShape || changes.probeTechnique || changes.probeCapture || changes.file;
  if (probes) d.updateProbes(changes.probeList || changes.file || d.drawn.size() != scene.probes.size());
  if (objects || probes) d.updateBindings();
  if (objects || changes.probeCapture || changes.probeList || changes.lights || changes.sky || changes.file) {
    d.updateKeys();
    d.startWork();
  }
}

void SceneRenderer::setInteractive(bool interactive) {
  Impl& d = *impl_;
  if (d.interactive == interactive) return;
  d.interactive = interactive;
  if (!interactive) {
    if (d.bindingsPostponed) d.updateBindings();
    d.startWork();
  }
}

bool SceneRenderer::workPending() const { return impl_->queue.pending() || impl_->stale(); }

bool SceneRenderer::step() {
  Impl& d = *impl_;
  d.makeResources();
  if (!d.queue.pending()) d.startWork();
  d.queue.step();
  if (!d.queue.pending()) {
    // The captures left the camera's uniforms behind in shared programs; see CubeCapture::renderInto.
    d.renderer->GetActiveCamera()->Modified();
  }
  return workPending();
}

double SceneRenderer::workProgress() const {
  return impl_->queue.pending() ? impl_->queue.progress() : (impl_->stale() ? 0.0 : 1.0);
}

bool SceneRenderer::finishWork(const std::function<bool(double)>& progress) {
  impl_->window->MakeCurrent();
  while (workPending()) {
    step();
    if (progress && !progress(workProgress())) return false;
  }
  return true;
}

void SceneRenderer::setProbesEnabled(bool enabled) {
  Impl& d = *impl_;
  if (d.probesEnabled == enabled) return;
  d.probesEnabled = enabled;
  d.updateBindings();
  d.startWork();
}

void SceneRenderer::applyCamera(const Camera& camera) {
  vtkCamera* vtk = impl_->renderer->GetActiveCamera();
  vtk->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  vtk->SetViewAngle(camera.verticalFovDegrees);
}

Camera SceneRenderer::currentCamera() const {
  vtkCamera* vtk = impl_->renderer->GetActiveCamera();
  Camera camera;
  vtk->GetPosition(&camera.position.x);
  vtk->GetFocalPoint(&camera.target.x);
  vtk->GetViewUp(&camera.up.x);
  camera.verticalFovDegrees = vtk->GetViewAngle();
  return camera;
}

vtkRenderer* SceneRenderer::renderer() const { return impl_->renderer; }

Box SceneRenderer::bounds() const { return impl_->bounds(); }

ImageRgba8 SceneRenderer::renderDisplay() {
  vtkOpenGLRenderWindow* window = impl_->window;
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels, 0);
  ImageRgba8 image{size[0], size[1], {}, {}};
  image.pixels.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * 4);
  for (int y = 0; y < size[1]; ++y) {
    const unsigned char* row = pixels->GetPointer(3 * static_cast<vtkIdType>(size[1] - 1 - y) * size[0]);
    std::uint8_t* out = &image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size[0]) * 4];
    for (int x = 0; x < size[0]; ++x) {
      out[4 * x] = row[3 * x];
      out[4 * x + 1] = row[3 * x + 1];
      out[4 * x + 2] = row[3 * x + 2];
      out[4 * x + 3] = 255;
    }
  }
  return image;
}

ImageRgbaF SceneRenderer::renderLinear(int width, int height, int samplesPerPixel) {
  Impl& d = *impl_;
  d.window->MakeCurrent();
  d.makeResources();
  d.renderer->ResetCameraClippingRange();
  std::vector<vtkProp*> props;
  for (DrawnObject& object : d.objects) {
    if (object.settings.visible) props.push_back(object.actor);
  }
  props.push_back(d.sky);
  vtkCamera* camera = d.renderer->GetActiveCamera();
  ImageRgbaF image = d.capture.renderFrame(camera, width, height, samplesPerSide(samplesPerPixel), props, d.lightPointers());
  camera->Modified();
  return image;
}

const Counters& SceneRenderer::counters() const { return impl_->state->counters; }
const Times& SceneRenderer::times() const { return impl_->times; }

std::size_t SceneRenderer::probeMemoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& entry : impl_->cache) bytes += entry.maps->bytes();
  return bytes;
}

std::string SceneRenderer::error() const { return impl_->state->error; }

void SceneRenderer::releaseGraphics() {
  Impl& d = *impl_;
  if (d.window == nullptr || d.state->brdfTable == 0) return;
  d.window->MakeCurrent();
  d.queue.release();
  d.capture.release();
  for (auto& probe : d.drawn) probe->maps.reset();
  d.cache.clear();
  d.state->sky.reset();
  d.shown.assign(d.shown.size(), std::string());
  d.shownSky.clear();
  glDeleteTextures(1, &d.state->brdfTable);
  glDeleteTextures(1, &d.state->blackCube);
  d.state->brdfTable = d.state->blackCube = 0;
  d.sky->ReleaseGraphicsResources(d.window);
}

}  // namespace boxprobe
