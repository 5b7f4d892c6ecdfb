// Projection rays in the picture: what vtkProjectionRays put out, drawn over a scene with dots where they hit and a bar
// that explains the colours. Seen in the window only: captures and linear pictures draw lists of their own. While it is
// off, nothing of it is in the renderer. Called by the window and by tools; knows no probe and no pointer.
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
  /// Off and empty at first. The renderer must outlive this object.
  explicit RayLayer(vtkRenderer* renderer);
  ~RayLayer();
  RayLayer(const RayLayer&) = delete;
  RayLayer& operator=(const RayLayer&) = delete;

  /// Output of vtkProjectionRays; null: none. Read now, and again when the colouring changes.
  void setRays(vtkPolyData* rays);
  void setVisible(bool visible);
  bool visible() const { return visible_; }
  /// `locked`: the range of a distance or error; left out: what the rays have.
  void setColoring(RayColoring coloring, const std::optional<RayRange>& locked = {});
  RayColoring coloring() const { return coloring_; }
  /// The range shown now.
  RayRange range() const { return range_; }
  /// The bar at the left edge; on by default.
  void setLegendVisible(bool visible);
  /// Core of a line in logical pixels (1.75 by default) and device pixels a logical one.
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
