// What colour a ray's line has, and the bar that says what the colours mean. Called by the ray layer; knows no OpenGL.
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
  /// `rays`: output of vtkProjectionRays. `locked`: the range of a number; left out: what the rays have.
  RayColors(vtkPolyData* rays, RayColoring coloring, const std::optional<RayRange>& locked);
  ~RayColors();

  /// Display colour of a cell; grey where the number is not defined.
  glm::vec3 color(long long cell) const;
  RayRange range() const { return range_; }
  /// Table and title; a number gets labels, a choice a swatch for each that occurs.
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
