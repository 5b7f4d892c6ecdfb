// The benchmark's renderer: two of the program's own, side by side in one off-screen window, so that frames of a
// technique and of the baseline can be drawn in turn without switching programs in between. Called by bench_command.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/session/offscreen_window.h"
#include "filters/reference/bench/benchmark.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class SceneRenderer;

class VtkBenchHost : public BenchHost {
 public:
  /// `settings`: of the window, of the size of the frames that are timed. `check` is called between pieces of work and
  /// may throw.
  VtkBenchHost(const OffscreenSettings& settings, std::vector<std::shared_ptr<const Model>> models,
               std::function<void()> check);
  ~VtkBenchHost() override;

  std::vector<LitPoint> surfaces(const Scene& scene, const Camera& camera, int width, int height) override;
  ReferenceBoxMaps maps(const Scene& scene) override;
  ImageRgbaF picture(const Scene& scene, const Camera& camera, int width, int height) override;
  double lookups(const Scene& scene, const Camera& camera, int width, int height,
                 const std::vector<glm::ivec2>& places) override;
  void prepareFrames(const Scene& technique, const Scene& baseline, const Camera& camera) override;
  void preparePlainFrames(const Scene& baseline, const Camera& camera) override;
  FrameSeconds frame(bool technique) override;
  const ReferenceScene& tracedScene(const Scene& scene) override;

  vtkOpenGLRenderWindow* window() const;
  const SceneRenderer& renderer() const;

 private:
  void warmUp();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxprobe
