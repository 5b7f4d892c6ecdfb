// Intersects rays with the surfaces of a renderer's actors, to which dragged faces snap. Needs neither OpenGL nor a ray
// tracer.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "filters/fit/rays/surface_rays.h"

class vtkMatrix4x4;
class vtkRenderer;
class vtkStaticCellLocator;

namespace boxprobe {

class ActorSurfaces : public SurfaceRays {
 public:
  /// The current visible actors with vtkPolyDataMapper, including parts of assemblies. Null: there are none.
  explicit ActorSurfaces(vtkRenderer* renderer);
  ~ActorSurfaces() override;
  ActorSurfaces(const ActorSurfaces&) = delete;
  ActorSurfaces& operator=(const ActorSurfaces&) = delete;

  /// Distance and normal only: roughness and reflectance are defaults.
  std::optional<SurfaceHit> first(const glm::dvec3& origin, const glm::dvec3& direction) const override;
  const Box& bounds() const override { return bounds_; }

 private:
  struct Surface {
    vtkSmartPointer<vtkStaticCellLocator> locator;
    vtkSmartPointer<vtkMatrix4x4> worldFromModel, modelFromWorld;
  };
  std::vector<Surface> surfaces_;
  Box bounds_{glm::dvec3(0.0), glm::dvec3(0.0)};
};

}  // namespace boxprobe
