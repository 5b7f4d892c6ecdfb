// The rays of the debug view: points of the chosen source, through the ray filter, into the layer over the picture.
// Called by the debug view; the layer is in the renderer only while rays are shown.
#pragma once

#include <vtkNew.h>

#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/explain/ray_settings.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/explain/explanation.h"
#include "filters/vtk/rays/ray_layer.h"
#include "filters/vtk/rays/ray_pixels.h"
#include "filters/vtk/rays/ray_sources.h"

class vtkProjectionRays;
class vtkRenderer;

namespace boxprobe {

class RayRig {
 public:
  /// `pixels`: the picture as it is now.
  RayRig(vtkRenderer* renderer, std::function<PixelRays()> pixels);
  ~RayRig();

  void setModels(std::vector<std::shared_ptr<const Model>> models);
  /// `geometry`: models, placements, materials or visibility changed as well as probes.
  void setScene(const Scene& scene, bool geometry);
  void setSettings(const RaySettings& settings);
  const RaySettings& settings() const { return settings_; }
  /// Logical pixels to device pixels.
  void setPixelScale(double scale) { layer_.setPixelScale(scale); }

  /// What is explained now; null: nothing. True if the rays changed by it.
  bool explain(const Explanation* explanation);
  void addClick(const Explanation& explanation);
  const std::vector<RaySample>& clicks() const { return clicks_; }
  void setClicks(std::vector<RaySample> clicks);
  /// Does where the camera stands change the rays?
  bool followsCamera() const { return settings_.shown && settings_.source == RaySource::Screen; }
  /// Brings the layer up to date. True if there is something to be drawn again.
  bool update();

  std::vector<std::string> objects();
  /// Why there are no rays, or how many points have some: a line for the panel.
  QString status() const { return status_; }
  long long rays() const;  ///< lines shown
  bool visible() const { return layer_.visible(); }
  /// Of what is shown, as VTK's XML poly data. Throws WorkError where it cannot be written, InputError without rays.
  void save(const std::string& path);

 private:
  RaySources& sources();
  std::vector<RaySample> samples();
  void compute(const std::vector<RaySample>& points);

  std::function<PixelRays()> pixels_;
  RayLayer layer_;
  vtkNew<vtkProjectionRays> filter_;
  std::vector<std::shared_ptr<const Model>> models_;
  Scene scene_;
  std::unique_ptr<RaySources> sources_;
  RaySettings settings_;
  std::optional<RaySample> explained_;
  glm::dvec3 eyeWorld_{0.0};
  std::vector<RaySample> clicks_;
  QString status_;
  bool stale_ = false;
};

}  // namespace boxprobe
