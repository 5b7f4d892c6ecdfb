#include "filters/vtk/widgets/actor_surfaces.h"

#include <vtkActor.h>
#include <vtkAssemblyPath.h>
#include <vtkGenericCell.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolygon.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkStaticCellLocator.h>

#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

glm::dvec3 multiplied(vtkMatrix4x4* matrix, const glm::dvec3& v, double w) {
  const double in[4] = {v.x, v.y, v.z, w};
  double out[4];
  matrix->MultiplyPoint(in, out);
  return {out[0], out[1], out[2]};
}

}  // namespace

ActorSurfaces::ActorSurfaces(vtkRenderer* renderer) {
  if (renderer == nullptr) return;
  const auto add = [this](vtkProp* prop, vtkProp* owner, vtkMatrix4x4* matrix) {
    auto* actor = vtkActor::SafeDownCast(prop);
    auto* mapper = actor != nullptr ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (mapper == nullptr || vtkSkybox::SafeDownCast(prop) != nullptr) return;
    if (actor->GetVisibility() == 0 || owner->GetVisibility() == 0) return;
    mapper->Update();
    vtkPolyData* data = mapper->GetInput();
    if (data == nullptr || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0) return;
    Surface surface;
    surface.locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    surface.locator->SetDataSet(data);
    surface.locator->BuildLocator();
    surface.worldFromModel = vtkSmartPointer<vtkMatrix4x4>::New();
    surface.worldFromModel->DeepCopy(matrix);
    surface.modelFromWorld = vtkSmartPointer<vtkMatrix4x4>::New();
    vtkMatrix4x4::Invert(matrix, surface.modelFromWorld);
    double b[6];
    data->GetBounds(b);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 at =
          multiplied(matrix, {b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)]}, 1.0);
      const bool one = surfaces_.empty() && corner == 0;
      bounds_ = one ? Box{at, at} : Box{glm::min(bounds_.min, at), glm::max(bounds_.max, at)};
    }
    surfaces_.push_back(surface);
  };
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it)) {
    if (prop->IsA("vtkAssembly") == 0) {
      if (auto* actor = vtkActor::SafeDownCast(prop)) add(prop, prop, actor->GetMatrix());
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath()) {
      add(path->GetLastNode()->GetViewProp(), prop, path->GetLastNode()->GetMatrix());
    }
  }
}

ActorSurfaces::~ActorSurfaces() = default;

std::optional<SurfaceHit> ActorSurfaces::first(const glm::dvec3& origin, const glm::dvec3& direction) const {
  // A distance beyond everything, from any start.
  const double far = glm::length(bounds_.size()) + glm::length(bounds_.center() - origin);
  std::optional<SurfaceHit> nearest;
  vtkNew<vtkGenericCell> cell;
  for (const Surface& surface : surfaces_) {
    const glm::dvec3 from = multiplied(surface.modelFromWorld, origin, 1.0);
    const glm::dvec3 to = multiplied(surface.modelFromWorld, origin + far * direction, 1.0);
    const double a[3] = {from.x, from.y, from.z}, b[3] = {to.x, to.y, to.z};
    double t = 0.0, x[3], parameters[3];
    int part = 0;
    vtkIdType id = -1;
    if (surface.locator->IntersectWithLine(a, b, 0.0, t, x, parameters, part, id, cell) == 0) continue;
    const double distance = t * far;
    if (cell->GetCellDimension() != 2 || (nearest && distance >= nearest->distance)) continue;
    double normal[3];
    vtkPolygon::ComputeNormal(cell->GetPoints(), normal);
    // Normals are transformed by the inverse transpose.
    glm::dvec3 world(0.0);
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) world[row] += surface.modelFromWorld->GetElement(k, row) * normal[k];
    }
    if (glm::length(world) == 0.0) continue;
    world = glm::normalize(world);
    SurfaceHit hit;
    hit.distance = distance;
    hit.back = glm::dot(world, direction) > 0.0;
    hit.normalWorld = hit.back ? -world : world;
    nearest = hit;
  }
  return nearest;
}

}  // namespace boxprobe
