// One scene drawn off the screen: display, window, renderer, baked files, models, scene, camera, captures, in this
// order and written once. Called by the sub-commands, the lessons and the measuring programs; says nothing to the user
// and knows no command line. What differs between them are the settings of the window and of what is shown.
#pragma once

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/offscreen_window.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

/// What is shown of a scene; left alone, the picture as the scene file has it.
struct ShownSettings {
  std::optional<Camera> camera = {};  ///< nothing: none is placed
  bool probes = true;                 ///< false: no reflections from probes and sky
  std::string bakedFolder = {};       ///< its baked files are used in place of captures; empty: none are
  /// The work is to make these baked probes and no more; empty: everything that the picture needs.
  std::vector<std::string> bakeTargets = {};
  SurfaceViewSettings view = {};
  std::vector<std::string> cutShort = {};  ///< of bakeTargets, as SceneRenderer::setBakeTargets has them
};

class OffscreenScene {
 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  /// In a window of its own. Throws as openOffscreenWindow() does.
  explicit OffscreenScene(const OffscreenSettings& settings);
  /// Beside others in one window: see setDrawn().
  explicit OffscreenScene(vtkSmartPointer<vtkOpenGLRenderWindow> window);
  /// Gives back what the renderer holds on the graphics side, whichever context was current.
  ~OffscreenScene();
  OffscreenScene(const OffscreenScene&) = delete;
  OffscreenScene& operator=(const OffscreenScene&) = delete;

  /// Brings the renderer up to `scene`; captures nothing. Of a scene that follows another one, only what differs is
  /// made again. Throws InputError for a custom probe whose picture cannot be read.
  void show(const Scene& scene, const Models& models, const ShownSettings& settings = {});
  /// Captures and filters what is missing; `progress` gets the finished share, 0..1, and may return false to stop.
  /// False if it was stopped. What could not be made is told by requireHealthy().
  bool capture(const std::function<bool(double)>& progress = {});
  /// To be drawn many times as it is now: programs with its numbers as constants (SceneRenderer::specializePrograms).
  void rest();
  /// A picture without its reflections, or with a mesh missing, must not pass for the real one: throws WorkError. What
  /// VTK said before this object was there does not count.
  void requireHealthy() const;

  /// Draws one frame into the window. CPU seconds that it took, of all threads: software OpenGL draws in this process.
  double timedFrame();
  /// Of several scenes in one window, those that are not drawn leave the picture alone. All are, at first.
  void setDrawn(bool drawn);
  /// A new renderer in the same window: nothing that was captured or shown is kept.
  void forget();

  SceneRenderer& renderer() { return *renderer_; }
  const SceneRenderer& renderer() const { return *renderer_; }
  vtkOpenGLRenderWindow* window() const { return window_; }

 private:
  vtkSmartPointer<vtkOpenGLRenderWindow> window_;
  std::unique_ptr<SceneRenderer> renderer_;
  std::optional<Scene> shown_;
  Models models_;  ///< of `shown_`
  std::string bakedFolder_;
  std::vector<std::string> bakeTargets_, cutShort_;
  std::string toldBefore_;
};

}  // namespace boxprobe
