// Intersects rays with a scene's triangles. The search structure is built for the first ray.
#pragma once

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <optional>

class vtkPolyData;
class vtkStaticCellLocator;

namespace boxprobe {

struct RaySceneHit {
  double distance = 0.0;  ///< along the unit direction, scene units
  glm::dvec3 positionWorld{0.0};
  long long cell = -1;
  glm::dvec3 facing{0.0};  ///< of the cell's plane, unit; zero for a degenerate cell
};

class RayScene {
 public:
  explicit RayScene(vtkPolyData* triangles);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first cell between two distances along `direction` (unit).
  std::optional<RaySceneHit> firstHit(const glm::dvec3& originWorld, const glm::dvec3& direction, double from,
                                      double to);
  /// Diagonal of the bounds; 0 for an empty scene.
  double diagonal() const { return diagonal_; }
  /// A distance from `originWorld` beyond the whole scene.
  double reachFrom(const glm::dvec3& originWorld) const;

 private:
  vtkSmartPointer<vtkPolyData> triangles_;
  vtkSmartPointer<vtkStaticCellLocator> locator_;  // null until needed
  glm::dvec3 center_{0.0};
  double diagonal_ = 0.0;
};

}  // namespace boxprobe
