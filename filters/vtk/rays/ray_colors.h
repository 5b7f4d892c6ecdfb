// The colours of rays' lines, and the bar that explains them.
#pragma once

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkScalarBarActor;
class vtkScalarsToColors;

namespace boxprobe {

enum class RayColoring {
  Kind,         ///< eye ray, normal, reflected ray, ...
  HitDistance,  ///< P to H, scene units
  Error,        ///< H to the true hit, scene units
  Face,         ///< of the box
  Probe,
};

struct RayRange {
  double low = 0.0, high = 1.0;
  bool operator==(const RayRange& o) const { return low == o.low && high == o.high; }
};

class RayColors {
 public:
  /// `rays`: output of vtkProjectionRays. `locked`: a fixed range; empty: that of the rays.
  RayColors(vtkPolyData* rays, RayColoring coloring, const std::optional<RayRange>& locked);
  ~RayColors();

  /// Display colour of a cell; grey for undefined values.
  glm::vec3 color(long long cell) const;
  RayRange range() const { return range_; }
  /// Sets table and title: labels for a number, swatches for the choices that occur.
  void describe(vtkScalarBarActor* bar) const;

 private:
  void useNumber(const std::optional<RayRange>& locked);
  void useChoices(const std::vector<glm::vec3>& colors, const std::vector<std::string>& names);

  vtkSmartPointer<vtkDataArray> values_;
  vtkSmartPointer<vtkScalarsToColors> table_;
  std::vector<glm::vec3> choices_;  // empty for a number
  std::string title_;
  RayRange range_;
};

}  // namespace boxprobe
