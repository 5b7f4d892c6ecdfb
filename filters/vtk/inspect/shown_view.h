// The current debug view: its range, if it depends on the scene, and its legend.
#pragma once

#include <utility>

#include "filters/core/scene/surface_view.h"
#include "filters/vtk/inspect/view_legend.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class ShownView {
 public:
  const SurfaceViewSettings& settings() const { return settings_; }
  void set(const SurfaceViewSettings& settings) { settings_ = settings; }
  /// Is it a debug view instead of the picture?
  bool any() const { return settings_.view != 0; }

  /// The ends of its scale: those that were set, else the row's, else the scene's.
  std::pair<double, double> range(const SceneContent& content) const;
  /// Applies the view to objects, draws and legend.
  void apply(SceneContent& content, DrawState& state, vtkRenderer* renderer);
  /// To be called before each frame. The context must be current.
  void upload(vtkOpenGLRenderWindow* window, SceneResources& resources) const;

 private:
  SurfaceViewSettings settings_;
  ViewLegend legend_;
};

}  // namespace boxprobe
