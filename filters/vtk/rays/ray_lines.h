// Collects projection rays as cells and arrays of a vtkPolyData, with the names of ray_arrays.h.
#pragma once

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/vtk/rays/ray_arrays.h"

class vtkPolyData;

namespace boxprobe {

/// One line and its values; -1 if undefined.
struct RayLine {
  RayKind kind = RayKind::Eye;
  glm::dvec3 from{0.0}, to{0.0};  ///< world
  int status = 0;
  int point = -1;
  int probe = -1;
  int face = -1;
  glm::dvec3 hitPoint{0.0};
  double hitDistance = -1.0;
  glm::dvec3 direction{0.0};
  double level = -1.0;
  double weight = 0.0;
  double lookupShare = 0.0;
  double trueDistance = -1.0;
  double error = -1.0;
  double through = -1.0;
};

class RayLines {
 public:
  RayLines();
  void add(const RayLine& line);
  void writeTo(vtkPolyData* output, const std::vector<std::string>& probeNames) const;

 private:
  vtkNew<vtkDoubleArray> points_;
  vtkNew<vtkIntArray> kind_, status_, point_, probe_, face_;
  vtkNew<vtkDoubleArray> hitPoint_, hitDistance_, direction_, level_, weight_, lookupShare_, trueDistance_, error_,
      through_;
};

}  // namespace boxprobe
