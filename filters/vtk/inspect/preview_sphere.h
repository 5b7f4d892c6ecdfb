// A sphere at a probe's origin that shows the probe's contents: a mirror, a rough metal or a diffuse white, lit by that
// probe's maps alone. Drawn in a separate layer over the scene (hidden by objects in front of it), so that captures,
// explanations and exported pictures do not contain it. While hidden it uses no resources.
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "filters/core/scene/scene.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/inspect/preview_settings.h"
#include "filters/vtk/surface/vtkProbeActor.h"

class vtkRenderer;
class vtkRenderWindow;

namespace boxprobe {

class PreviewSphere {
 public:
  PreviewSphere(vtkRenderWindow* window, vtkRenderer* scene, std::shared_ptr<DrawState> state);
  ~PreviewSphere();

  void show(const PreviewSphereSettings& settings);
  const PreviewSphereSettings& settings() const { return settings_; }
  /// To be called before each picture while it is shown, with the probe and its current maps. Null hides it.
  void follow(const Probe* probe, const std::shared_ptr<const ProbeMaps>& maps);
  /// The levels of these maps that the sphere samples; missing ones are shown unfiltered.
  LevelMask sampled(const ProbeMaps& maps) const;
  /// Needs the window's context current.
  void release();
  bool shown() const { return settings_.kind != SphereKind::Off; }

  /// A tenth of the box's shortest edge of nonzero length.
  static double radius(const Box& box);

 private:
  void build();
  void applyMaterial();

  vtkRenderWindow* window_;
  vtkRenderer* scene_;
  std::shared_ptr<DrawState> state_;
  PreviewSphereSettings settings_;
  vtkSmartPointer<vtkRenderer> layer_;  ///< null until it is first shown
  vtkSmartPointer<vtkProbeActor> actor_;
  std::shared_ptr<DrawnProbe> drawn_ = std::make_shared<DrawnProbe>();
};

}  // namespace boxprobe
