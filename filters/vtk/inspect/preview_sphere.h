// A sphere at a probe's origin that shows what the probe holds: a mirror, a rough metal or a diffuse white, lit by that
// probe's maps alone. Owned by the scene renderer. Drawn in a layer of its own over the scene (behind whatever stands
// before it), so that no capture, explanation or exported picture sees it; hidden it is not there at all.
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
  /// Before every picture, while it is shown: where the probe stands and what it holds now. Null hides it.
  void follow(const Probe* probe, const std::shared_ptr<const ProbeMaps>& maps);
  /// Levels of these maps that the sphere samples; those that are not filtered yet it shows as they are.
  LevelMask sampled(const ProbeMaps& maps) const;
  /// With the window's context current.
  void release();
  bool shown() const { return settings_.kind != SphereKind::Off; }

  /// A tenth of the box's shortest edge that has a length.
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
