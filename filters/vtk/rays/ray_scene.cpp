// See ray_scene.h.
#include "filters/vtk/rays/ray_scene.h"

#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkStaticCellLocator.h>

#include <glm/geometric.hpp>

namespace boxprobe {

RayScene::RayScene(vtkPolyData* triangles) : triangles_(triangles) {
  if (triangles_ == nullptr || triangles_->GetNumberOfCells() == 0) return;
  double b[6];
  triangles_->GetBounds(b);
  center_ = 0.5 * glm::dvec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
  diagonal_ = glm::length(glm::dvec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
}

RayScene::~RayScene() = default;

double RayScene::reachFrom(const glm::dvec3& originWorld) const {
  return glm::length(originWorld - center_) + diagonal_;
}

std::optional<RaySceneHit> RayScene::firstHit(const glm::dvec3& originWorld, const glm::dvec3& direction, double from,
                                              double to) {
  if (diagonal_ <= 0.0 || !(to > from)) return std::nullopt;
  if (!locator_) {
    locator_ = vtkSmartPointer<vtkStaticCellLocator>::New();
    locator_->SetDataSet(triangles_);
    locator_->BuildLocator();
  }
  const glm::dvec3 a = originWorld + from * direction;
  const glm::dvec3 b = originWorld + to * direction;
  // An invisible tolerance, so that no ray slips between two triangles.
  const double tolerance = 1.0e-9 * diagonal_;
  RaySceneHit hit;
  double parametric[3];
  double t = 0.0;
  int subId = 0;
  vtkIdType cell = -1;
  if (locator_->IntersectWithLine(&a.x, &b.x, tolerance, t, &hit.positionWorld.x, parametric, subId, cell) == 0 ||
      cell < 0) {
    return std::nullopt;
  }
  hit.cell = cell;
  vtkIdType corners = 0;
  const vtkIdType* ids = nullptr;
  triangles_->GetCellPoints(cell, corners, ids);
  vtkPolygon::ComputeNormal(triangles_->GetPoints(), static_cast<int>(corners), ids, &hit.facing.x);
  hit.distance = glm::dot(hit.positionWorld - originWorld, direction);
  return hit;
}

}  // namespace boxprobe
