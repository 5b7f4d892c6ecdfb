// The parts of a scene renderer, and their interaction in a frame, an explanation or a linear picture.
#pragma once

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "filters/core/geometry/ground_shadow.h"
#include "filters/core/geometry/sky_openness.h"
#include "filters/core/scene/document.h"
#include "filters/explain/explanation.h"
#include "filters/vtk/frame/mirror_set.h"
#include "filters/vtk/frame/moving_shadows.h"
#include "filters/vtk/frame/picture_frames.h"
#include "filters/vtk/frame/sun_shadows.h"
#include "filters/vtk/inspect/object_outline.h"
#include "filters/vtk/inspect/preview_sphere.h"
#include "filters/vtk/inspect/shown_view.h"
#include "filters/vtk/inspect/surface_inspector.h"
#include "filters/vtk/probes/probe_set.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/scene/traced_work.h"
#include "filters/vtk/scene/vtkCulledRenderer.h"
#include "filters/vtk/surface/vtkGroundShadow.h"

namespace boxprobe {

struct SceneParts {
  explicit SceneParts(vtkOpenGLRenderWindow* window);
  ~SceneParts();
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  vtkOpenGLRenderWindow* window;
  std::shared_ptr<DrawState> state;
  vtkNew<vtkCulledRenderer> renderer;
  std::uint64_t seen = 0;  ///< generation of the drawn objects that the probes know
  vtkNew<vtkCallbackCommand> frameObserver;
  SceneContent content;
  ProbeSet probes;
  SurfaceInspector inspector;
  PictureFrames frames;
  MirrorSet mirrors;
  PreviewSphere sphere;
  ObjectOutline outline;
  WindowView windowView;
  MovingShadows shadows;
  SunShadows suns;
  ShownView view;
  TracedWork<GroundShadow> groundWork;
  TracedWork<SkyOpenness> opennessWork;
  vtkNew<vtkGroundShadow> ground;
  bool interactive = false;
  bool givenAnew = false;  ///< content.given was replaced since it was last used
  /// Fingerprints computed once per set of models and image of the sky.
  std::vector<std::string> contentKeys;                  ///< of the objects
  int contentKeysOf = -1;                                ///< content.modelGeneration
  std::vector<std::weak_ptr<const Model>> hidingModels;  ///< the models of hidingModelsKey
  std::string hidingModelsKey;                           ///< contents of everything that can hide a lamp
  std::weak_ptr<const ImageRgbaF> skyPixelsOf;
  std::string skyPixels;

  /// Implementations of SceneRenderer's functions of these names.
  void sync(const Scene& scene, const Changes& changes);
  void setProbesEnabled(bool enabled);
  void setInteractive(bool active);
  void useVtkLighting(int columns, int rows, const std::vector<glm::vec2>& table);
  /// Determines which captures are stale.
  void updateCaptures();
  std::string hidingKey();
  /// Has what is traced of the whole scene made again where that has changed.
  void askTraced(bool changed);
  void takeOpenness(std::chrono::milliseconds wait);
  void step();
  bool workPending() const { return probes.workPending() || groundWork.pending() || opennessWork.pending(); }
  std::vector<Explanation> explain(const std::vector<glm::ivec2>& pixels, int width, int height);
  ImageRgbaF renderLinear(int width, int height, int samplesPerPixel, int frameLimit,
                          const std::function<void(int)>& beforeFrame);
  void refine(const RefineSettings& settings);
  ImageRgbaF renderRefined(int width, int height, int samplesPerPixel, const RefineSettings& settings,
                           const std::function<void(int)>& beforeFrame);
  void releaseGraphics();

  void setWindowView(const WindowView& wanted);
  /// To objects made or moved since.
  void applyWindowView();
  void setCut(bool cut);

  /// Deleting maps that are replaced or dropped needs their context.
  void makeCurrent();
  void applyView() { view.apply(content, *state, renderer); }

 private:
  ImageRgbaF renderLinear(int width, int height, int samplesPerPixel, const std::function<vtkPicturePass*()>& pass,
                          const std::function<void(int)>& beforeFrame);
  void beginFrame();
  void endFrame();
  /// Prepares any picture with the active camera; needs the context current.
  void prepareDraws();
  void drawMirrors(double aspect, int width, int height, int samples);
};

}  // namespace boxprobe
