// See bench_host.h.
#include "app/cli/command/bench_host.h"

#include <algorithm>
#include <optional>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

struct VtkBenchHost::Impl {
  Impl(const OffscreenSettings& settings, std::vector<std::shared_ptr<const Model>> m, std::function<void()> c)
      : models(std::move(m)), check(std::move(c)), first(settings) {
    onCpu = drawsOnCpu();
    if (!onCpu && glGenQueries != nullptr) glGenQueries(1, &query);
  }

  /// Ready to be drawn, its captures made.
  void show(OffscreenScene& shown, const Scene& scene, const Camera& camera) {
    shown.show(scene, models, {camera});
    shown.capture([this](double) {
      check();
      return true;
    });
    shown.requireHealthy();
  }

  std::vector<std::shared_ptr<const Model>> models;
  std::function<void()> check;
  OffscreenScene first;                  ///< pictures and explanations; frames of the technique
  std::optional<OffscreenScene> second;  ///< frames of the baseline; made when frames are first timed
  bool onCpu = true;
  GLuint query = 0;
  std::optional<Scene> tracedOf;
  std::unique_ptr<ReferenceScene> traced;
};

VtkBenchHost::VtkBenchHost(const OffscreenSettings& settings, std::vector<std::shared_ptr<const Model>> models,
                           std::function<void()> check)
    : impl_(std::make_unique<Impl>(settings, std::move(models), std::move(check))) {}

VtkBenchHost::~VtkBenchHost() {
  impl_->first.window()->MakeCurrent();
  if (impl_->query != 0) glDeleteQueries(1, &impl_->query);
}

std::vector<LitPoint> VtkBenchHost::surfaces(const Scene& scene, const Camera& camera, int width, int height) {
  Impl& d = *impl_;
  d.show(d.first, scene, camera);
  std::vector<LitPoint> all;
  // An explanation holds every texel it looked up: a band of rows at a time.
  constexpr int kRows = 32;
  for (int top = 0; top < height; top += kRows) {
    d.check();
    std::vector<glm::ivec2> places;
    for (int y = top; y < std::min(top + kRows, height); ++y) {
      for (int x = 0; x < width; ++x) places.emplace_back(x, y);
    }
    for (const Explanation& e : d.first.renderer().explain(places, width, height)) all.push_back(litPoint(e));
  }
  return all;
}

ReferenceBoxMaps VtkBenchHost::maps(const Scene& scene) {
  ReferenceBoxMaps maps;
  maps.energy = scene.energy;
  for (const Probe& probe : scene.probes) maps.probes.push_back(impl_->first.renderer().mapsOnCpu(probe.name));
  maps.sky = impl_->first.renderer().mapsOnCpu("");
  return maps;
}

ImageRgbaF VtkBenchHost::picture(const Scene& scene, const Camera& camera, int width, int height) {
  Impl& d = *impl_;
  d.show(d.first, scene, camera);
  ImageRgbaF image = d.first.renderer().renderLinear(width, height, 1);
  d.first.requireHealthy();
  return image;
}

double VtkBenchHost::lookups(const Scene& scene, const Camera& camera, int width, int height,
                             const std::vector<glm::ivec2>& places) {
  Impl& d = *impl_;
  d.show(d.first, scene, camera);
  double sum = 0.0;
  for (const Explanation& e : d.first.renderer().explain(places, width, height)) sum += e.lookupCount;
  return places.empty() ? 0.0 : sum / static_cast<double>(places.size());
}

void VtkBenchHost::prepareFrames(const Scene& technique, const Scene& baseline, const Camera& camera) {
  Impl& d = *impl_;
  if (!d.second) d.second.emplace(d.first.window());
  d.show(d.first, technique, camera);
  d.show(*d.second, baseline, camera);
  warmUp();
}

void VtkBenchHost::preparePlainFrames(const Scene& baseline, const Camera& camera) {
  Impl& d = *impl_;
  if (!d.second) d.second.emplace(d.first.window());
  d.show(d.first, baseline, camera);
  d.show(*d.second, baseline, camera);
  d.first.renderer().setProbesEnabled(false);
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
  d.first.setDrawn(technique);
  d.second->setDrawn(!technique);
  OffscreenScene& drawn = technique ? d.first : *d.second;
  // Where the picture is put together from frames, what there is would only be shown again.
  drawn.renderer().restartPicture();
  FrameSeconds seconds;
  const bool timer = !d.onCpu && d.query != 0;
  if (timer) glBeginQuery(GL_TIME_ELAPSED, d.query);
  seconds.cpu = drawn.timedFrame();
  if (timer) {
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(d.query, GL_QUERY_RESULT, &nanoseconds);
    seconds.gpu = 1.0e-9 * static_cast<double>(nanoseconds);
  }
  drawn.requireHealthy();
  return seconds;
}

const ReferenceScene& VtkBenchHost::tracedScene(const Scene& scene) {
  Impl& d = *impl_;
  if (!d.traced || !(*d.tracedOf == scene)) {
    const SceneOfDrawnSky drawn = withDrawnSky(scene);
    d.traced = std::make_unique<ReferenceScene>(drawn.scene, d.models, drawn.skyImage);
    d.tracedOf = scene;
  }
  return *d.traced;
}

vtkOpenGLRenderWindow* VtkBenchHost::window() const {
  return impl_->first.window();
}

const SceneRenderer& VtkBenchHost::renderer() const {
  return impl_->first.renderer();
}

}  // namespace boxprobe
