// See bench_host.h.
#include "app/cli/command/bench_host.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

#include <algorithm>
#include <optional>

#include "app/session/offscreen_window.h"
#include "app/session/scene_work.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

/// A renderer and what it shows now.
struct Shown {
  explicit Shown(vtkOpenGLRenderWindow* window) : renderer(window) {}
  SceneRenderer renderer;
  std::optional<Scene> scene;
  Camera camera;

  void show(const Scene& wanted, const Camera& view, const std::vector<std::shared_ptr<const Model>>& models,
            const std::function<void()>& check) {
    if (!scene) renderer.setModels(models);
    const Changes changes = scene ? difference(*scene, wanted) : Changes::all();
    if (!scene || changes.any()) renderer.sync(wanted, changes);
    scene = wanted;
    renderer.setProbesEnabled(true);
    camera = view;
    renderer.applyCamera(view);
    if (!renderer.pictureError().empty()) throw InputError(renderer.pictureError());
    renderer.finishWork([&](double) {
      check();
      return true;
    });
    requireHealthy(renderer);
  }
};

}  // namespace

struct VtkBenchHost::Impl {
  Impl(std::vector<std::shared_ptr<const Model>> m, std::shared_ptr<const ImageRgbaF> sky, int w, int h,
       std::function<void()> c)
      : models(std::move(m)), skyImage(std::move(sky)), check(std::move(c)), window(makeOffscreenWindow(w, h, 1)) {
    first = std::make_unique<Shown>(window);
    onCpu = drawsOnCpu();
    if (!onCpu && glGenQueries != nullptr) glGenQueries(1, &query);
  }

  std::vector<std::shared_ptr<const Model>> models;
  std::shared_ptr<const ImageRgbaF> skyImage;
  std::function<void()> check;
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  std::unique_ptr<Shown> first;   ///< pictures and explanations; frames of the technique
  std::unique_ptr<Shown> second;  ///< frames of the baseline; made when frames are first timed
  bool onCpu = true;
  GLuint query = 0;
  std::optional<Scene> tracedOf;
  std::unique_ptr<ReferenceScene> traced;
};

VtkBenchHost::VtkBenchHost(std::vector<std::shared_ptr<const Model>> models, std::shared_ptr<const ImageRgbaF> skyImage,
                           int frameWidth, int frameHeight, std::function<void()> check)
    : impl_(std::make_unique<Impl>(std::move(models), std::move(skyImage), frameWidth, frameHeight, std::move(check))) {
}

VtkBenchHost::~VtkBenchHost() {
  for (Shown* shown : {impl_->first.get(), impl_->second.get()}) {
    if (shown != nullptr) shown->renderer.releaseGraphics();
  }
  if (impl_->query != 0) glDeleteQueries(1, &impl_->query);
}

std::vector<LitPoint> VtkBenchHost::surfaces(const Scene& scene, const Camera& camera, int width, int height) {
  Impl& d = *impl_;
  d.first->show(scene, camera, d.models, d.check);
  std::vector<LitPoint> all;
  // An explanation holds every texel it looked up: a band of rows at a time.
  constexpr int kRows = 32;
  for (int top = 0; top < height; top += kRows) {
    d.check();
    std::vector<glm::ivec2> places;
    for (int y = top; y < std::min(top + kRows, height); ++y) {
      for (int x = 0; x < width; ++x) places.emplace_back(x, y);
    }
    for (const Explanation& e : d.first->renderer.explain(places, width, height)) all.push_back(litPoint(e));
  }
  return all;
}

ReferenceBoxMaps VtkBenchHost::maps(const Scene& scene) {
  ReferenceBoxMaps maps;
  for (const Probe& probe : scene.probes) maps.probes.push_back(impl_->first->renderer.mapsOnCpu(probe.name));
  maps.sky = impl_->first->renderer.mapsOnCpu("");
  return maps;
}

ImageRgbaF VtkBenchHost::picture(const Scene& scene, const Camera& camera, int width, int height) {
  Impl& d = *impl_;
  d.first->show(scene, camera, d.models, d.check);
  ImageRgbaF image = d.first->renderer.renderLinear(width, height, 1);
  requireHealthy(d.first->renderer);
  return image;
}

double VtkBenchHost::lookups(const Scene& scene, const Camera& camera, int width, int height,
                             const std::vector<glm::ivec2>& places) {
  Impl& d = *impl_;
  d.first->show(scene, camera, d.models, d.check);
  double sum = 0.0;
  for (const Explanation& e : d.first->renderer.explain(places, width, height)) sum += e.lookupCount;
  return places.empty() ? 0.0 : sum / static_cast<double>(places.size());
}

void VtkBenchHost::prepareFrames(const Scene& technique, const Scene& baseline, const Camera& camera) {
  Impl& d = *impl_;
  if (!d.second) d.second = std::make_unique<Shown>(d.window);
  d.first->show(technique, camera, d.models, d.check);
  d.second->show(baseline, camera, d.models, d.check);
  warmUp();
}

void VtkBenchHost::preparePlainFrames(const Scene& baseline, const Camera& camera) {
  Impl& d = *impl_;
  if (!d.second) d.second = std::make_unique<Shown>(d.window);
  d.first->show(baseline, camera, d.models, d.check);
  d.second->show(baseline, camera, d.models, d.check);
  d.first->renderer.setProbesEnabled(false);
  warmUp();
}

// The first frames compile programs and fill caches.
void VtkBenchHost::warmUp() {
  for (int i = 0; i < 2; ++i) {
    frame(true);
    frame(false);
  }
}

FrameSeconds VtkBenchHost::frame(bool technique) {
  Impl& d = *impl_;
  d.check();
  d.first->renderer.renderer()->SetDraw(technique ? 1 : 0);
  d.second->renderer.renderer()->SetDraw(technique ? 0 : 1);
  // Where the picture is put together from frames, what there is would only be shown again.
  (technique ? d.first : d.second)->renderer.restartPicture();
  FrameSeconds seconds;
  const bool timer = !d.onCpu && d.query != 0;
  if (timer) glBeginQuery(GL_TIME_ELAPSED, d.query);
  const double start = processCpuSeconds();
  d.window->Render();
  d.window->WaitForCompletion();  // software OpenGL works on in its threads after the call has returned
  seconds.cpu = processCpuSeconds() - start;
  if (timer) {
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(d.query, GL_QUERY_RESULT, &nanoseconds);
    seconds.gpu = 1.0e-9 * static_cast<double>(nanoseconds);
  }
  requireHealthy((technique ? d.first : d.second)->renderer);
  return seconds;
}

const ReferenceScene& VtkBenchHost::tracedScene(const Scene& scene) {
  Impl& d = *impl_;
  if (!d.traced || !(*d.tracedOf == scene)) {
    d.traced = std::make_unique<ReferenceScene>(scene, d.models, d.skyImage);
    d.tracedOf = scene;
  }
  return *d.traced;
}

vtkOpenGLRenderWindow* VtkBenchHost::window() const {
  return impl_->window;
}

const SceneRenderer& VtkBenchHost::renderer() const {
  return impl_->first->renderer;
}

}  // namespace boxprobe
