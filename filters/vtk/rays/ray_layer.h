// Draws the output of vtkProjectionRays over a scene, with dots at hits and a bar that explains the colours. Visible in
// the window only: captures and linear pictures draw separate lists. While off, it has nothing in the renderer.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "filters/vtk/rays/ray_colors.h"

class vtkPolyData;
class vtkRayLinesProp;
class vtkRenderer;
class vtkScalarBarActor;

namespace boxprobe {

class RayLayer {
 public:
  /// Initially off and empty. The renderer must outlive this object.
  explicit RayLayer(vtkRenderer* renderer);
  ~RayLayer();
  RayLayer(const RayLayer&) = delete;
  RayLayer& operator=(const RayLayer&) = delete;

  /// Output of vtkProjectionRays; null: none. Read now, and again when the colouring changes.
  void setRays(vtkPolyData* rays);
  void setVisible(bool visible);
  bool visible() const { return visible_; }
  /// `locked`: a fixed range of distances or errors; empty: that of the rays.
  void setColoring(RayColoring coloring, const std::optional<RayRange>& locked = {});
  RayColoring coloring() const { return coloring_; }
  /// The current range.
  RayRange range() const { return range_; }
  /// The bar at the left edge; on by default.
  void setLegendVisible(bool visible);
  /// Width of a line's core in logical pixels (1.75 by default), and below device pixels per logical pixel.
  void setLineWidth(double pixels);
  void setPixelScale(double devicePixels);

 private:
  void rebuild();
  void place();

  vtkRenderer* renderer_;
  vtkNew<vtkRayLinesProp> lines_;
  vtkNew<vtkScalarBarActor> bar_;
  vtkSmartPointer<vtkPolyData> rays_;
  RayColoring coloring_ = RayColoring::Kind;
  std::optional<RayRange> locked_;
  RayRange range_;
  double lineWidth_ = 1.75;
  bool visible_ = false, legend_ = true;
  bool stale_ = false;  // rays or colouring changed while off
};

}  // namespace boxprobe
